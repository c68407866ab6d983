#!/bin/sh
# Install the programs that check printed pages and completion: TeX, Chromium, pdftotext, LibreOffice, pandoc, ps, fish,
# patch, man, mandoc, npm, Java.
set -eu

packages="texlive-latex-base texlive-latex-recommended texlive-luatex texlive-latex-extra texlive-science texlive-lang-german lmodern chromium poppler-utils libreoffice-calc-nogui libreoffice-writer-nogui libreoffice-math-nogui fonts-liberation pandoc procps fish patch man-db groff mandoc libjaxb-java"
# A Node.js that is not from Debian brings its own npm, and Debian's would replace it.
command -v npm >/dev/null || packages="$packages nodejs npm"
command -v java >/dev/null || packages="$packages default-jdk-headless"

missing=""
for package in $packages; do
    dpkg-query --show --showformat='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
done
[ -z "$missing" ] && exit 0

export DEBIAN_FRONTEND=noninteractive
apt-get update --quiet
# shellcheck disable=SC2086
apt-get install --yes --quiet --no-install-recommends $missing
