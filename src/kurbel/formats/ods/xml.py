"""Elements of XML as text."""

from __future__ import annotations

from html import escape

NAMESPACES = " ".join(
    f'xmlns:{prefix}="{name}"'
    for prefix, name in {
        **{
            prefix: f"urn:oasis:names:tc:opendocument:xmlns:{name}:1.0"
            for prefix, name in {
                "office": "office", "table": "table", "text": "text", "style": "style", "draw": "drawing",
                "number": "datastyle", "meta": "meta", "config": "config", "fo": "xsl-fo-compatible",
                "svg": "svg-compatible", "manifest": "manifest",
            }.items()
        },
        "dc": "http://purl.org/dc/elements/1.1/",
        "xlink": "http://www.w3.org/1999/xlink",
    }.items()
)  # fmt: skip


def element(name: str, *content: str, **attributes: object) -> str:
    """Return an element; style__row_height="15pt" is its attribute style:row-height, None is left out."""
    inner, begin = "".join(content), opened(name, **attributes)
    return f"{begin}{inner}</{name}>" if inner else f"{begin[:-1]}/>"


def opened(name: str, **attributes: object) -> str:
    """Return how an element begins."""
    said = "".join(
        f' {key.replace("__", ":").replace("_", "-")}="{escape(str(value))}"'
        for key, value in attributes.items()
        if value is not None
    )
    return f"<{name}{said}>"


def document(root: str, *content: str) -> str:
    """Return a file of OpenDocument."""
    begin, end = around(root)
    return f"{begin}{''.join(content)}{end}"


def around(root: str) -> tuple[str, str]:
    """Return what stands before and behind the content of a file."""
    begin = f'<?xml version="1.0" encoding="UTF-8"?>\n<office:{root} {NAMESPACES} office:version="1.3">'
    return begin, f"</office:{root}>\n"
