#!/bin/sh
# Install the programs that check printed pages and completion: TeX, Chromium, pdftotext, fish, patch.
set -eu

packages="texlive-latex-base texlive-latex-recommended texlive-luatex texlive-lang-german lmodern chromium poppler-utils fish patch"

missing=""
for package in $packages; do
    dpkg-query --show --showformat='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
done
[ -z "$missing" ] && exit 0

export DEBIAN_FRONTEND=noninteractive
apt-get update --quiet
# shellcheck disable=SC2086
apt-get install --yes --quiet --no-install-recommends $missing
