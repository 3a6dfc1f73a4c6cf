"""The results as an SVG picture: a bar a goal, how many times as good as asked for, on a logarithmic scale."""
import math
from xml.sax.saxutils import escape

ROW, TOP, LEFT, WIDTH, RIGHT = 18, 56, 400, 420, 150  # pixels
LEAST, MOST = 0.1, 10                                 # ends of the scale

STYLE = """
  text { font: 12px system-ui, sans-serif; fill: #1f2328 }
  .head { font-size: 15px; font-weight: 600 }
  .faint { fill: #59636e }
  .line { stroke: #d1d9e0 } .goal { stroke: #1f2328; stroke-width: 1.5 }
  .met { fill: #1a7f37 } .missed { fill: #bc4c00 } .paper { fill: #ffffff }
  @media (prefers-color-scheme: dark) {
    text { fill: #f0f6fc } .faint { fill: #9198a1 } .line { stroke: #3d444d } .goal { stroke: #f0f6fc }
    .met { fill: #3fb950 } .missed { fill: #f0883e } .paper { fill: #0d1117 }
  }
"""


def across(reach):
    """Where on the scale."""
    limited = min(max(reach, LEAST), MOST)
    return LEFT + WIDTH * math.log(limited / LEAST) / math.log(MOST / LEAST)


def bar(row, y):
    x, goal = across(row.reach), across(1)
    kind = "met" if row.met else "missed"
    value = f"{row.ours:.{row.digits}f} {row.unit}"
    return (f'  <text x="{LEFT - 10}" y="{y + 12}" text-anchor="end"><tspan class="faint">{escape(row.stage)}</tspan> '
            f'{escape(row.what)}</text>\n'
            f'  <rect class="{kind}" x="{min(x, goal):.1f}" y="{y + 3}" width="{max(abs(x - goal), 1):.1f}" '
            f'height="11"/>\n'
            f'  <text class="faint" x="{LEFT + WIDTH + 10}" y="{y + 12}">{escape(value)}</text>\n')


def svg(report):
    rows = [row for row in report.rows if row.reach is not None]
    height = TOP + ROW * len(rows) + 34
    bottom = TOP + ROW * len(rows)
    ticks = "".join(
        f'  <line class="{"goal" if tick == 1 else "line"}" x1="{across(tick):.1f}" x2="{across(tick):.1f}" '
        f'y1="{TOP - 4}" y2="{bottom + 4}"/>\n'
        f'  <text class="faint" x="{across(tick):.1f}" y="{bottom + 20}" text-anchor="middle">{tick:g} x</text>\n'
        for tick in (0.1, 0.2, 0.5, 1, 2, 5, 10))
    bars = "".join(bar(row, TOP + ROW * i) for i, row in enumerate(rows))
    total = LEFT + WIDTH + RIGHT
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{total}" height="{height}" '
            f'viewBox="0 0 {total} {height}" role="img">\n'
            f'  <title>Speed against the goals: {escape(report.summary())}</title>\n  <style>{STYLE}  </style>\n'
            f'  <rect class="paper" width="{total}" height="{height}"/>\n'
            f'  <text class="head" x="16" y="26">How many times as good as the goal asks for</text>\n'
            f'  <text class="faint" x="16" y="44">{escape(report.machine.get("Processor", ""))}, commit '
            f'{escape(report.machine.get("Commit", ""))}. {escape(report.summary())}</text>\n'
            f'{ticks}{bars}</svg>\n')
