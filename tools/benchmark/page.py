"""Results in a page that people write: what stands between <!-- bench: NAME --> and <!-- bench end --> is replaced, the
text around it stays."""
import re

from . import tables

BLOCK = re.compile(r"(<!-- bench: ([^\n]*?) -->\n).*?(<!-- bench end -->)", re.DOTALL)


def blocks(report):
    """Texts by name."""
    machine = "".join(f"- {name}: {value}\n" for name, value in report.machine.items())
    return {"machine": f"{machine}\n{report.summary()}\n", **dict(report.parts(tables.markdown))}


def filled(page, report):
    """The page with all blocks that the report has; a page without any gets them at its end."""
    texts = blocks(report)
    if not BLOCK.search(page):
        return page + "".join(f"\n<!-- bench: {name} -->\n{text}<!-- bench end -->\n" for name, text in texts.items())
    return BLOCK.sub(lambda found: found[1] + texts[found[2]] + found[3] if found[2] in texts else found[0], page)
