"""The HTML report of a study in a browser: study_browser_test.py FOLDER

FOLDER has the files of tests/report/browser_test.cpp: study.html, study.svg, and large.html with 300 scenes and 30
settings.
Screenshots go there too. Exit status 0: all is well; 1: something is not; 77: no browser.
"""

import time

import browser

TESTS = []
STILL_LIFE = "showcase/still_life.ray"
NASTY = "</script><img src=x onerror=alert(1)>.ray"


def test(function):
    TESTS.append(function)
    return function


def report(page):
    return page.run("return JSON.parse(document.getElementById('report').textContent)")


def scene_of(page, name):
    return next(scene for scene in report(page)["scenes"] if scene["scene"] == name)


def rows(page, table):
    """Of a table: what its cells say, by the titles of the columns."""
    return page.run("""return [...document.querySelectorAll(arguments[0] + " tbody tr")].filter((row) => row.cells.length > 1)
        .map((row) => Object.fromEntries([...row.cells].map((cell) => [cell.dataset.title, cell.textContent])))""", table)


def open_scene(page, name):
    page.run("""[...document.querySelectorAll("#scenes a")].find((a) => a.textContent === arguments[0]).click()""", name)
    page.wait("return document.getElementById('detail').open")
    assert opened(page) == name
    page.wait("return document.querySelector('#detail .plot canvas')")


def opened(page):
    return page.run("""const detail = document.getElementById("detail");
        return detail.open ? detail.querySelector("h2").textContent : null""")


def shown_setting(page):
    return page.one("#detail .shown h3").text.strip()


def pictures_shown(page, number):
    page.wait("""const images = [...document.querySelectorAll(".stage img")];
        return images.length === arguments[0] && images.every((image) => image.complete && image.naturalWidth > 0)""", number)


def view(page, plot):
    return [float(part) for part in page.one(plot).get_attribute("data-view").split()]


def point_of(page, plot, setting):
    """Looks for the point with the pointer; its place from the middle of the plot and the text of its tip."""
    found = page.wait("""const over = document.querySelector(arguments[0] + " .u-over");
        if (!over) return null;
        const box = over.getBoundingClientRect();
        for (let y = 3; y < box.height; y += 5)
          for (let x = 3; x < box.width; x += 5) {
            over.dispatchEvent(new MouseEvent("mousemove", { clientX: box.left + x, clientY: box.top + y, bubbles: true }));
            const tip = over.querySelector(".tip");
            if (!tip.hidden && tip.textContent.startsWith(arguments[1] + ":"))
              return [x - box.width / 2, y - box.height / 2, tip.textContent];
          }
        return null""", plot, setting)
    return round(found[0]), round(found[1]), found[2]


def colours(page, plot):
    """How many colours its canvas has."""
    return page.wait("""const canvas = document.querySelector(arguments[0] + " canvas");
        if (!canvas) return 0;
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        return new Set(new Uint32Array(data.buffer)).size""", plot)


def type_limit(page, selector, text):
    field = page.one(selector)
    page.run("arguments[0].focus(); arguments[0].select()", field)
    page.press(text)


def fastest(scene, below):
    good = [result for result in scene["results"]
            if result["error"]["against"] == "converged" and result["error"]["rms"] < below]
    return min(good, key=lambda result: result["ms"]["median"])["setting"] if good else None


@test
def the_page_tells_what_was_measured(page, folder):
    page.load(folder / "study.html")
    assert page.one("h1").text == "Study: scenes"
    assert page.one(".headline").text == "Time and error of 14 settings on 4 scenes"
    top = page.one("#top").text.replace("\u202f", " ")
    for part in ("AMD EPYC", "avx512", "trace 0.1.0", "trace study scenes/ --report study.html", "22 Nov 2026", "5 min 12 s"):
        assert part in top, (part, top)
    claims = page.texts(".claim")
    assert len(claims) == 2 and "3.4\u00d7" in claims[0] and "equal error" in claims[0] and "1.1\u00d7 to 9\u00d7" in claims[0], claims
    assert len(rows(page, "#settings")) == 14 and len(rows(page, "#scenes")) == 4
    assert "none measured" in page.one(".claims .answers").text


@test
def plots_are_drawn(page, folder):
    page.load(folder / "study.html")
    assert colours(page, "#charts .plot") > 30
    open_scene(page, STILL_LIFE)
    assert colours(page, "#detail .plot") > 30
    page.screenshot(folder / "scene.png")


@test
def hovering_names_a_setting_and_a_click_goes_to_its_row(page, folder):
    page.load(folder / "study.html")
    x, y, text = point_of(page, "#charts .plot", "2x2")
    total = report(page)["all"]["results"][1]
    assert text == f"2x2: {total['time']:.3g}\u00d7 the time, {total['error']:.3g}\u00d7 the error", (text, total)
    page.one("#settings select").send_keys("Depth")
    assert len(rows(page, "#settings")) == 2
    page.run("scrollTo(0, 0)")
    page.actions().move_to_element_with_offset(page.one("#charts .u-over"), x, y).click().perform()
    assert page.run("return document.activeElement.dataset.setting") == "2x2"
    assert page.one("#settings tr[aria-current]").get_attribute("data-setting") == "2x2"
    assert len(rows(page, "#settings")) == 14


@test
def wheel_and_drag_zoom_and_a_double_click_shows_all(page, folder):
    page.load(folder / "study.html")
    page.wait("return document.querySelector('#charts .u-over')")
    whole = view(page, "#charts .plot")
    over = page.one("#charts .u-over")
    scroll = """const over = document.querySelector("#charts .u-over"), box = over.getBoundingClientRect();
        const event = new WheelEvent("wheel", { deltaY: arguments[0], clientX: box.left + box.width / 3,
            clientY: box.top + box.height / 3, bubbles: true, cancelable: true });
        over.dispatchEvent(event);
        return event.defaultPrevented"""
    assert not page.run(scroll, 100), "the page scrolls where all is seen"
    assert page.run(scroll, -100)
    near = view(page, "#charts .plot")
    assert near[0] > whole[0] and near[1] < whole[1] and near[2] > whole[2] and near[3] < whole[3], (whole, near)
    assert page.one("#charts .whole").is_displayed()
    page.actions().double_click(over).perform()
    assert view(page, "#charts .plot") == whole
    page.run("scrollTo(0, 0)")
    page.actions().move_to_element_with_offset(over, -100, -60).click_and_hold().move_by_offset(120, 90).release().perform()
    dragged = view(page, "#charts .plot")
    assert dragged[1] / dragged[0] < whole[1] / whole[0] and dragged[3] / dragged[2] < whole[3] / whole[2], dragged
    page.one("#charts .whole").click()
    assert view(page, "#charts .plot") == whole and not page.one("#charts .whole").is_displayed()


@test
def a_plot_is_used_by_keyboard(page, folder):
    page.load(folder / "study.html")
    page.wait("return document.querySelector('#charts .u-over')")
    page.run("document.querySelector('#charts .plot').focus()")
    whole = view(page, "#charts .plot")
    page.press("+")
    assert view(page, "#charts .plot")[0] > whole[0]
    page.press("0")
    assert view(page, "#charts .plot") == whole
    order = sorted(report(page)["all"]["results"], key=lambda total: total["time"])
    for total in order[:3]:
        page.press(browser.Keys.ARROW_RIGHT)
        assert page.one("#charts .tip").text.startswith(total["setting"] + ":")
    page.press(browser.Keys.ENTER)
    assert page.run("return document.activeElement.dataset.setting") == order[2]["setting"]


@test
def the_legend_hides_an_axis_in_all_plots(page, folder):
    page.load(folder / "study.html")
    page.wait("return document.querySelector('#charts .u-over')")
    before = page.run("return document.querySelector('#charts canvas').toDataURL()")
    page.one("#charts .legend [data-axis=depth]").click()
    assert page.one("#charts .legend [data-axis=depth]").get_attribute("aria-pressed") == "false"
    page.wait("return document.querySelector('#charts canvas').toDataURL() !== arguments[0]", before)
    open_scene(page, STILL_LIFE)
    own = page.one("#detail .legend [data-axis=depth]")
    assert own.get_attribute("aria-pressed") == "false"
    own.click()
    page.escape()
    assert page.one("#charts .legend [data-axis=depth]").get_attribute("aria-pressed") == "true"
    page.wait("return document.querySelector('#charts canvas').toDataURL() === arguments[0]", before)


@test
def tables_sort_by_a_click_on_their_heads(page, folder):
    page.load(folder / "study.html")
    totals = {total["setting"]: total for total in report(page)["all"]["results"]}
    names = lambda: page.run("return [...document.querySelectorAll('#settings tbody tr')].map((row) => row.dataset.setting)")
    assert names() == list(totals)
    for key in ("time", "error"):
        for descending in (False, True):
            page.one(f"#settings [data-sort={key}]").click()
            values = [totals[name][key] for name in names()]
            assert values == sorted(values, reverse=descending), (key, values)
            assert page.run("return document.activeElement.closest('th').ariaSort") == ("descending" if descending else "ascending")
    page.one("#scenes [data-sort=time]").click()
    scenes = [row["Scene"] for row in rows(page, "#scenes")]
    assert scenes == [STILL_LIFE, "features/refraction.ray", "features/box.ray", NASTY], scenes
    open_scene(page, STILL_LIFE)
    page.one("#detail [data-sort=error]").click()
    results = {result["setting"]: result for result in scene_of(page, STILL_LIFE)["results"]}
    errors = [results[name]["error"]["rms"]
              for name in page.run("return [...document.querySelectorAll('#detail tr[data-setting]')].map((row) => row.dataset.setting)")]
    assert len(errors) == 14 and errors == sorted(errors), errors


@test
def a_typed_limit_answers_for_all_scenes_and_for_one(page, folder):
    page.load(folder / "study.html")
    scenes = {scene["scene"]: scene for scene in report(page)["scenes"]}
    best = lambda: {row["Scene"]: row["Fastest good enough"] for row in rows(page, "#scenes")}
    for limit in ("1", "0.3", "2.5", "0,0001"):
        type_limit(page, "#results .limit", limit)
        expected = {name: fastest(scene, float(limit.replace(",", "."))) or "\u2013" for name, scene in scenes.items()}
        assert best() == expected, (limit, best(), expected)
    assert "none measured in 4 of 4 scenes" in page.one("#tally").text, page.one("#tally").text
    type_limit(page, "#results .limit", "x")
    assert page.one("#results .limit").get_attribute("aria-invalid") == "true"
    open_scene(page, STILL_LIFE)
    type_limit(page, "#detail .limit", "3.25")
    assert page.run("return document.activeElement.className") == "limit", "typing goes on"
    typed = page.one("#detail .typed")
    setting = fastest(scenes[STILL_LIFE], 3.25)
    assert typed.find_element("css selector", "[data-setting]").get_attribute("data-setting") == setting
    page.escape()
    assert page.one("#results .limit").get_attribute("value") == "3.25"
    assert best()[STILL_LIFE] == setting


@test
def a_click_on_a_point_shows_the_settings_pictures(page, folder):
    page.load(folder / "study.html")
    open_scene(page, STILL_LIFE)
    assert shown_setting(page) == "adaptive 4"  # the one recommended
    pictures_shown(page, 2)
    x, y, text = point_of(page, "#detail .plot", "2x2")
    result = scene_of(page, STILL_LIFE)["results"][1]
    assert text.startswith("2x2: 93.6\u202fms, ") and f"{result['error']['rms']:.3f} \u00b1 0.020 levels" in text, text
    page.actions().move_to_element_with_offset(page.one("#detail .u-over"), x, y).click().perform()
    assert shown_setting(page) == "2x2"
    pictures_shown(page, 2)
    assert page.texts("#detail .side") == ["This setting", "Converged"]
    assert page.one("#detail tr[aria-current]").get_attribute("data-setting") == "2x2"
    page.one("#detail [aria-label='Compare with'] [data-value=heat]").click()
    assert page.texts("#detail .side") == ["This setting", "Heat map"]
    page.one("#detail .choice [data-value=side]").click()
    pictures_shown(page, 4)  # the solution too
    page.one("#detail .choice [data-value=swipe]").click()
    page.press("b")
    page.wait("return document.querySelector('.blink')")
    page.press("b")
    page.one("#detail tr[data-setting='4x4'] button.setting").click()
    assert "no picture was kept" in page.one("#detail .shown").text
    pictures_shown(page, 2)  # the converged one and the solution


@test
def a_smaller_picture_is_enlarged_to_the_others(page, folder):
    page.load(folder / "study.html")
    open_scene(page, STILL_LIFE)
    page.one("#detail tr[data-setting='half'] button.setting").click()
    pictures_shown(page, 2)
    sizes = page.wait("""const images = [...document.querySelectorAll(".stage img")];
        return images.every((image) => image.style.width) && images.map((image) => [image.naturalWidth, image.getBoundingClientRect().width])""")
    assert sizes[0][0] == 80 and sizes[1][0] == 160 and sizes[0][1] == sizes[1][1], sizes
    text = page.wait("""const image = document.querySelector(".stage img"), box = image.getBoundingClientRect();
        image.dispatchEvent(new MouseEvent("mousemove", { bubbles: true, composed: true, clientX: box.left + box.width / 2, clientY: box.top + box.height / 2 }));
        const text = document.querySelector(".probe").textContent;
        return text.includes("This setting") && text.includes("Converged") && text""")
    assert text.startswith("x 40, y "), text


@test
def the_table_of_a_scene_has_the_figures(page, folder):
    page.load(folder / "study.html")
    open_scene(page, STILL_LIFE)
    row = next(row for row in rows(page, "#detail") if row.get("Setting", "").startswith("2x2"))
    result = scene_of(page, STILL_LIFE)["results"][1]
    for title, part in (("Setting", "--aa 2"), ("Time", "93.6\u202fms"), ("Time", "90.8\u202fms\u201397.3\u202fms"),
                        ("Error", f"{result['error']['rms']:.3f} \u00b1 0.020"), ("Gain", "for +69.6\u202fms over 1"),
                        ("Memory", "11.8\u202fMiB"), ("To solution", "2.4\u202f%")):
        assert part in row[title], (title, part, row)
    assert row["Rays"] == f"{sum(result['rays'].values()):,}"
    text = page.one("#detail").text
    for part in ("against extended", "same picture", "recommended", "0.021 levels", "256 samples a pixel"):
        assert part in text, part


@test
def options_are_copied(page, folder):
    page.load(folder / "study.html")
    page.driver.execute_cdp_cmd("Browser.grantPermissions", {"permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"]})
    page.one("#settings tr[data-setting='3x3'] .copy").click()
    page.wait("return document.querySelector(\"#settings tr[data-setting='3x3'] .copy\").textContent === 'Copied'")
    assert page.driver.execute_async_script("navigator.clipboard.readText().then(arguments[0], (e) => arguments[0](String(e)))") == "--aa 3"


@test
def keys_go_from_scene_to_scene_and_filter(page, folder):
    page.load(folder / "study.html")
    order = [row["Scene"] for row in rows(page, "#scenes")]
    for name in order + order[:1]:
        page.press("n")
        page.wait("return document.getElementById('detail').open")
        assert opened(page) == name, (opened(page), name)
    page.press("p")
    assert opened(page) == order[-1]
    page.escape()
    assert opened(page) is None and page.run("return document.activeElement.textContent") == order[-1]
    page.press("/")
    page.press("BOX fea")
    assert [row["Scene"] for row in rows(page, "#scenes")] == ["features/box.ray"]
    assert page.one("#count").text == "1 of 4 scenes"
    page.press(" nothing")
    assert "No scene matches." in page.one("#scenes").text
    page.escape()
    assert len(rows(page, "#scenes")) == 4
    page.press("?")
    assert "Next scene" in page.one("#help").text
    page.escape()


@test
def an_address_names_a_scene(page, folder):
    page.load(folder / "study.html", "#features%2Fbox.ray")
    assert opened(page) == "features/box.ray"


@test
def hostile_names_and_missing_pictures_do_no_harm(page, folder):
    page.load(folder / "study.html")
    open_scene(page, NASTY)
    assert page.run("return document.querySelectorAll('[onerror], #detail img[src=x]').length") == 0
    assert len(page.all("#detail tr[data-setting]")) == 3
    page.wait("return document.querySelector('.stage .no-picture')?.textContent.includes('no such file')")


@test
def dark_and_light_follow_the_system_until_chosen(page, folder):
    looks = {}
    for scheme in ("light", "dark"):
        page.emulate(prefers_color_scheme=scheme)
        page.load(folder / "study.html")
        colours(page, "#charts .plot")
        page.screenshot(folder / f"{scheme}.png")
        looks[scheme] = page.run("return [getComputedStyle(document.body).backgroundColor, document.querySelector('#charts canvas').toDataURL()]")
    assert looks["light"][0] != looks["dark"][0] and looks["light"][1] != looks["dark"][1]
    page.one("[aria-label=Colours] [data-value=light]").click()
    page.wait("return document.querySelector('#charts canvas').toDataURL() === arguments[0]", looks["light"][1])
    page.one("[aria-label=Colours] [data-value=dark]").click()
    open_scene(page, STILL_LIFE)
    pictures_shown(page, 2)
    page.screenshot(folder / "scene_dark.png")
    page.escape()
    page.one("[aria-label=Colours] [data-value=system]").click()


@test
def paper_gets_the_colours_of_paper(page, folder):
    drawn = lambda: page.run("return document.querySelector('#charts canvas').toDataURL()")
    paper = {}
    for scheme in ("light", "dark"):
        page.emulate(prefers_color_scheme=scheme)
        page.load(folder / "study.html")
        colours(page, "#charts .plot")
        before = drawn()
        page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "media": "print", "features": [{"name": "prefers-color-scheme", "value": scheme}]})
        page.wait("return document.querySelector('#charts canvas').toDataURL() !== arguments[0]", before)
        paper[scheme] = drawn()
        page.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    assert paper["light"] == paper["dark"]


@test
def the_svg_picture_follows_the_system_and_its_names_keep_apart(page, folder):
    paper = {}
    for scheme in ("light", "dark"):
        page.emulate(prefers_color_scheme=scheme)
        page.load(folder / "study.svg")
        paper[scheme] = page.run("return getComputedStyle(document.querySelector('.paper')).fill")
        page.screenshot(folder / f"svg_{scheme}.png")
    assert paper == {"light": "rgb(255, 255, 255)", "dark": "rgb(13, 17, 23)"}, paper
    boxes = page.run("""return [...document.querySelectorAll("text, .mark")].map((each) => {
        const { left, top, right, bottom } = each.getBoundingClientRect();
        return [each.textContent, left, top, right, bottom] })""")
    names = [box for box in boxes if box[0] in ("adaptive 4", "adaptive 16", "extended", "half")]
    assert len(names) == 4, names
    for name in names:
        for other in boxes:
            apart = name[3] < other[1] or name[1] > other[3] or name[4] < other[2] or name[2] > other[4]
            assert name is other or apart, (name, other)


@test
def all_is_reached_with_the_tab_key(page, folder):
    page.load(folder / "study.html")
    page.wait("return document.querySelector('#charts .u-over')")
    reached = []
    for _ in range(75):
        page.press(browser.Keys.TAB)
        reached.append(page.run("""const e = document.activeElement;
            return [e.tagName, e.id || e.dataset.sort || e.dataset.axis || e.className || e.textContent,
                getComputedStyle(e).outlineStyle !== "none"]"""))
    words = [word for _, word, _ in reached]
    for expected in ("skip", "plot", "depth", "error", "copy", "filter-text", "limit", STILL_LIFE):
        assert expected in words, (expected, words)
    assert all(outlined for tag, _, outlined in reached if tag != "BODY"), reached


@test
def a_telephone_shows_it_without_scrolling_sideways(page, folder):
    page.size(360, 740)
    page.load(folder / "study.html")
    colours(page, "#charts .plot")
    wide = "return [document.documentElement.scrollWidth, document.documentElement.clientWidth]"
    assert page.run(wide) == [360, 360], page.run(wide)
    page.screenshot(folder / "narrow.png")
    open_scene(page, STILL_LIFE)
    pictures_shown(page, 2)
    inside = page.run("const d = document.getElementById('detail'); return [d.scrollWidth, d.clientWidth]")
    assert inside[0] <= inside[1], inside
    page.screenshot(folder / "narrow_scene.png")


@test
def three_hundred_scenes_do_not_freeze_it(page, folder):
    begin = time.time()
    page.load(folder / "large.html")
    page.wait("return document.querySelectorAll('#scenes tbody tr').length === 300")
    assert time.time() - begin < 10, time.time() - begin
    assert len(rows(page, "#settings")) == 30
    seconds = page.run("""const field = document.querySelector("#results .limit"), begin = performance.now();
        field.value = "0.5";
        field.dispatchEvent(new Event("input"));
        document.body.offsetHeight;
        return (performance.now() - begin) / 1000""")
    assert seconds < 2, seconds
    seconds = page.run("""const begin = performance.now();
        location.hash = "#folder%2Fscene7.ray";
        return begin""")
    page.wait("return document.querySelector('#detail .plot canvas')")
    assert len(page.all("#detail tr[data-setting]")) == 30


@test
def nothing_is_left_of_a_scene_that_was_closed(page, folder):
    page.load(folder / "study.html")
    for name in (STILL_LIFE, "features/box.ray"):
        open_scene(page, name)
        page.escape()
    page.one("[aria-label=Colours] [data-value=dark]").click()
    assert len(page.all(".uplot")) == 1
    page.one("[aria-label=Colours] [data-value=system]").click()


if __name__ == "__main__":
    browser.main(TESTS)
