"""The HTML report of a batch in a browser: browser_test.py FOLDER

FOLDER has the pages of tests/report/browser_test.cpp: one.html (one renderer), two.html (two), linked.html
(pictures beside it). Screenshots go there too. Exit status 0: all is well; 1: something is not; 77: no browser.
"""

import time

import browser

TESTS = []


def test(function):
    TESTS.append(function)
    return function


def rows(page):
    return page.run("""return [...document.querySelectorAll("#list tbody tr")].map((row) => ({
        scene: row.dataset.scene, failed: row.classList.contains("failed"),
        cells: [...row.cells].map((cell) => cell.textContent)}))""")


def column(page, title):
    at = page.texts(".list thead th").index(title)
    return [row["cells"][at] for row in rows(page)]


def number(text):
    """Of a cell; None where there is none."""
    text = text.replace("\u202f", " ").split()
    if text[0] == "\u2013":
        return None
    value = 0.0 if text[0] == "<" else float(text[0])
    return value * {"ms": 0.001}.get(text[-1], 1)


def opened(page):
    """The scene whose details are open, or None."""
    return page.run("""const detail = document.getElementById("detail");
        return detail.open ? detail.querySelector("h2").lastChild.textContent : null""")


def open_scene(page, scene):
    page.run("""[...document.querySelectorAll("#list a")].find((a) => a.textContent === arguments[0]).click()""", scene)
    page.wait("return document.getElementById('detail').open")
    assert opened(page) == scene


def measurements(page, scene):
    return page.run("""return JSON.parse(document.getElementById("report").textContent).results
        .find((each) => each.scene === arguments[0]).comparison.measurements""", scene)


def crops_drawn(page, scene):
    """Waits for them; the number of regions, each of which has three."""
    number_of_regions = len(measurements(page, scene)["worst"])
    assert number_of_regions >= 1
    page.wait("return document.querySelectorAll('.crop canvas[data-drawn]').length === arguments[0]",
              3 * number_of_regions)
    return number_of_regions


def pictures_shown(page, number_of_pictures):
    page.wait("""const images = [...document.querySelectorAll(".stage img")];
        return images.length === arguments[0] && images.every((image) => image.complete && image.naturalWidth > 0)""",
              number_of_pictures)


@test
def every_result_is_a_row_and_failures_come_first(page, folder):
    page.load(folder / "one.html")
    shown = rows(page)
    assert len(shown) == 13, shown
    failed = [row["failed"] for row in shown]
    assert failed == sorted(failed, reverse=True) and 0 < sum(failed) < len(failed), failed
    assert page.one(".headline").text == f"{sum(failed)} of 13 results fail"
    scenes = {row["scene"]: row["failed"] for row in shown}
    for scene in ("showcase/still_life.ray", "features/reflection.ray", "features/cone.ray", "wrong.ray"):
        assert scenes[scene], scene
    for scene in ("features/sphere.ray", "features/box.ray"):
        assert not scenes[scene], scene


@test
def failures_are_told_in_words(page, folder):
    page.load(folder / "one.html")
    verdicts = dict(zip([row["scene"] for row in rows(page)], column(page, "Verdict")))
    assert verdicts["showcase/still_life.ray"] == "beyond tolerance"
    assert verdicts["features/cone.ray"] == "size differs"
    assert verdicts["features/box.ray"] == "within tolerance"
    assert verdicts["features/sphere.ray"] == "identical"
    assert verdicts["deep/recursion.ray"] == "crashed"
    diagnoses = dict(zip([row["scene"] for row in rows(page)], column(page, "Diagnosis")))
    assert diagnoses["showcase/still_life.ray"] == "shadows are missing"
    assert "wrong.ray:2:" in diagnoses["wrong.ray"], diagnoses["wrong.ray"]


@test
def a_click_on_a_column_head_sorts(page, folder):
    page.load(folder / "one.html")
    for key, title, largest_first in (("error", "RMSE", True), ("time", "Time", True), ("name", "Scene", False)):
        for descending in (largest_first, not largest_first):
            page.one(f".list [data-sort={key}]").click()
            values = column(page, title)
            if key != "name":
                values = [value for value in map(number, values) if value is not None]
                absent = [number(text) is None for text in column(page, title)]
                assert absent == sorted(absent), "what has no figure comes last"
            assert values == sorted(values, reverse=descending), (key, descending, values)
            head = page.run("return document.activeElement.closest('th').getAttribute('aria-sort')")
            assert head == ("descending" if descending else "ascending"), head
    page.run("""const sort = document.querySelector(".toolbar select"); sort.value = "error";
        sort.dispatchEvent(new Event("change"))""")
    values = [value for value in map(number, column(page, "RMSE")) if value is not None]
    assert values == sorted(values, reverse=True)


@test
def the_filter_leaves_what_matches(page, folder):
    page.load(folder / "one.html")
    page.press("/")
    assert page.run("return document.activeElement.id") == "filter-text"
    page.press("normals TRI")
    assert [row["scene"] for row in rows(page)] == ["features/trimesh_normals.ray"]
    assert page.one("#count").text == "1 of 13 results"
    page.escape()
    assert len(rows(page)) == 13
    page.press("/")
    page.press("shadows are")  # of the diagnosis
    assert [row["scene"] for row in rows(page)] == ["showcase/still_life.ray"]
    page.press(" nowhere")
    assert rows(page) == [] and "No result matches." in page.one("#list").text
    page.escape()
    for verdict, word in (("crashed", "crashed"), ("identical", "identical")):
        page.one(f".chips [data-value={verdict}]").click()
        assert column(page, "Verdict") and set(column(page, "Verdict")) == {word}
    page.one(".chips [data-value=failures]").click()
    assert all(row["failed"] for row in rows(page)) and rows(page)


@test
def pictures_are_swiped_by_keyboard_and_mouse(page, folder):
    page.load(folder / "one.html")
    open_scene(page, "showcase/still_life.ray")
    pictures_shown(page, 2)
    widths = page.run("return [...document.querySelectorAll('.stage img')].map((image) => image.naturalWidth)")
    assert widths == [160, 160], widths
    slider = page.one("img-comparison-slider")
    value = lambda: page.run("return document.querySelector('img-comparison-slider').value")
    assert value() == 50
    page.run("arguments[0].focus()", slider)
    page.actions().key_down(browser.Keys.ARROW_RIGHT).pause(0.3).key_up(browser.Keys.ARROW_RIGHT).perform()
    assert value() > 50, value()
    page.actions().move_to_element_with_offset(slider, -100, 0).click().perform()
    assert value() < 50, value()
    assert slider.get_attribute("aria-valuenow") == str(round(value()))
    page.screenshot(folder / "swipe.png")
    page.one("#detail .choice[aria-label='Compare with'] [data-value=heat]").click()
    pictures_shown(page, 2)
    assert page.one(".side.right").text == "Heat map"
    page.one("#detail .choice [data-value=side]").click()
    pictures_shown(page, 3)
    regions = len(measurements(page, "showcase/still_life.ray")["worst"])
    assert len(page.all(".region")) == 2 * regions > 0  # on both
    page.one("#detail .choice [data-value=swipe]").click()
    page.one("#detail .choice [data-value=solution]").click()


@test
def zoom_shows_whole_pixels(page, folder):
    page.load(folder / "one.html")
    open_scene(page, "showcase/still_life.ray")
    pictures_shown(page, 2)
    page.run("""const zoom = document.querySelector("#detail select"); zoom.value = "4";
        zoom.dispatchEvent(new Event("change"))""")
    sizes = page.run("""return [...document.querySelectorAll(".stage img")].map((image) =>
        [image.getBoundingClientRect().width, getComputedStyle(image).imageRendering])""")
    assert sizes == [[640, "pixelated"]] * 2, sizes


@test
def worst_regions_are_enlarged_pixel_by_pixel(page, folder):
    page.load(folder / "one.html")
    open_scene(page, "showcase/still_life.ray")
    regions = crops_drawn(page, "showcase/still_life.ray")
    # Every pixel of a canvas is the one of its block's first corner: blocks of one colour, without smoothing.
    scales = page.run("""return [...document.querySelectorAll(".crop canvas")].map((canvas) => {
        const scale = Number(canvas.dataset.drawn), { width, height } = canvas;
        const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
        const at = (x, y) => [0, 1, 2].map((c) => data[4 * (y * width + x) + c]).join();
        const colours = new Set();
        for (let y = 0; y < height; ++y)
          for (let x = 0; x < width; ++x) {
            if (at(x, y) !== at(x - x % scale, y - y % scale)) return 0;
            colours.add(at(x, y));
          }
        return colours.size > 1 ? scale : 0; })""")
    assert len(scales) == 3 * regions and min(scales) >= 4, scales
    assert page.texts(".crop figcaption") == ["Rendered", "Solution", "Heat map"] * regions


@test
def b_blinks_and_stops(page, folder):
    page.load(folder / "one.html")
    open_scene(page, "showcase/still_life.ray")
    page.press("b")
    pictures_shown(page, 2)
    for shown in ("solution", "picture"):
        page.wait("return document.querySelector('.blink').dataset.shown === arguments[0]", shown)
    visible = page.run("""return [...document.querySelectorAll(".blink > div")].filter((each) =>
        getComputedStyle(each).visibility === "visible").length""")
    assert visible == 1
    page.press("b")
    assert page.all(".blink") == [] and page.all("img-comparison-slider")
    page.one("#detail .choice [data-value=blink]").click()
    assert page.all(".blink")


@test
def nothing_blinks_by_itself_where_motion_is_not_welcome(page, folder):
    page.emulate(prefers_reduced_motion="reduce")
    page.load(folder / "one.html")
    open_scene(page, "showcase/still_life.ray")
    page.press("b")
    shown = lambda: page.run("return document.querySelector('.blink').dataset.shown")
    time.sleep(1.5)
    assert shown() == "picture"
    page.press("b")
    assert shown() == "solution"
    page.press("b")
    assert shown() == "picture"


@test
def n_and_p_go_from_failure_to_failure(page, folder):
    page.load(folder / "one.html")
    failures = [row["scene"] for row in rows(page) if row["failed"]]
    for scene in failures + failures[:1]:
        page.press("n")
        page.wait("return document.getElementById('detail').open")
        assert opened(page) == scene, (opened(page), scene)
    page.press("p")
    page.wait("return document.querySelector('#detail h2').lastChild.textContent === arguments[0]", failures[-1])
    page.escape()
    assert opened(page) is None
    focused = page.run("return document.activeElement.textContent")
    assert focused == failures[-1], focused
    assert page.run("return location.hash") == ""


@test
def help_opens_and_closes(page, folder):
    page.load(folder / "one.html")
    page.press("?")
    assert "Next failure" in page.one("#help").text
    page.escape()
    assert not page.run("return document.getElementById('help').open")


@test
def all_is_reached_with_the_tab_key(page, folder):
    page.load(folder / "one.html")
    reached = []
    for _ in range(60):
        page.press(browser.Keys.TAB)
        reached.append(page.run("""const e = document.activeElement;
            return [e.tagName, e.className || e.id || e.dataset.sort || e.textContent,
                getComputedStyle(e).outlineStyle !== "none"]"""))
    assert reached[0][1] == "skip"
    words = [word for _, word, _ in reached]
    for expected in ("filter-text", "error", "showcase/still_life.ray"):
        assert expected in words, (expected, words)
    assert all(outlined for tag, _, outlined in reached if tag != "BODY"), reached


@test
def details_tell_figures_messages_and_times(page, folder):
    page.load(folder / "one.html")
    open_scene(page, "features/reflection.ray")
    text = page.one("#detail").text
    for part in ("Reflection is missing", "RMSE", "PSNR", "Largest difference", "Foreground", "Time"):
        assert part in text, part
    page.escape()
    page.wait("return !document.getElementById('detail').open")
    open_scene(page, "wrong.ray")
    message = page.one("#detail pre").text
    assert message.startswith("wrong.ray:2:") and "\n" in message, message
    assert "There is no picture." in page.one("#detail").text


@test
def broken_pictures_and_markup_in_names_do_no_harm(page, folder):
    page.load(folder / "one.html")
    open_scene(page, "features/groups.ray")
    page.wait("return document.querySelectorAll('.stage img, .stage .no-picture').length >= 2")
    page.escape()
    open_scene(page, "</script><img src=x onerror=alert(1)>.ray")
    assert page.run("return document.querySelectorAll('[onerror]').length") == 0


@test
def pictures_of_different_sizes_stand_beside_each_other(page, folder):
    page.load(folder / "one.html")
    open_scene(page, "features/cone.ray")
    pictures_shown(page, 2)
    assert page.all("img-comparison-slider") == []
    captions = page.texts(".stage figcaption")
    assert [caption.split(", ")[0] for caption in captions] == ["Rendered", "Solution"], captions
    assert "96" in captions[0] and "160" in captions[1], captions


@test
def the_pixel_under_the_pointer_is_told(page, folder):
    page.load(folder / "one.html")
    open_scene(page, "showcase/still_life.ray")
    pictures_shown(page, 2)
    largest = measurements(page, "showcase/still_life.ray")["largest"]
    text = page.wait("""const image = document.querySelector(".stage img"), box = image.getBoundingClientRect();
        const at = (share, size) => (share + 0.5) / size;
        image.dispatchEvent(new MouseEvent("mousemove", { bubbles: true, composed: true,
            clientX: box.left + at(arguments[0], image.naturalWidth) * box.width,
            clientY: box.top + at(arguments[1], image.naturalHeight) * box.height }));
        const text = document.querySelector(".probe").textContent;
        return text.includes("Rendered") && text.includes("Solution") && text""", largest["x"], largest["y"])
    where, rendered, solution = text.split(" \u00b7 ")
    assert where == f"x {largest['x']}, y {largest['y']}", text
    assert int(rendered.split()[1 + largest["channel"]]) == largest["test"], (text, largest)
    assert int(solution.split()[1 + largest["channel"]]) == largest["reference"], (text, largest)


@test
def charts_are_drawn_and_their_points_open_scenes(page, folder):
    page.load(folder / "one.html")
    page.wait("return document.querySelectorAll('.chart canvas').length === 2")
    inked = page.run("""return [...document.querySelectorAll(".chart canvas")].map((canvas) => {
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        return new Set(new Uint32Array(data.buffer)).size })""")
    assert min(inked) > 10, inked
    # A point somewhere: look for it with the pointer until its name appears.
    found, *at = page.run("""const over = document.querySelectorAll(".chart .u-over")[1];
        const box = over.getBoundingClientRect();
        for (let y = 2; y < box.height; y += 6)
          for (let x = 2; x < box.width; x += 6) {
            const at = { clientX: box.left + x, clientY: box.top + y, bubbles: true };
            over.dispatchEvent(new MouseEvent("mousemove", at));
            const tip = over.querySelector(".tip");
            if (tip.hidden) continue;
            return [tip.textContent, x - box.width / 2, y - box.height / 2];
          }""")
    over = page.all(".chart .u-over")[1]
    page.actions().move_to_element_with_offset(over, round(at[0]), round(at[1])).click().perform()
    page.wait("return document.getElementById('detail').open")
    assert found.startswith(opened(page) + ":"), found
    page.escape()
    links = page.run("""document.querySelector(".points").open = true;
        return [...document.querySelectorAll(".points a")].map((a) => a.textContent)""")
    assert len(links) == 8 and "showcase/still_life.ray" in links, links
    page.one(".points a").click()
    page.wait("return document.getElementById('detail').open")
    assert opened(page) == links[0]


@test
def an_address_names_a_scene(page, folder):
    page.load(folder / "one.html", "#features%2Fcone.ray")
    assert opened(page) == "features/cone.ray"
    page.run("history.pushState(null, '', '#x'); location.hash = '#features%2Fsphere.ray'")
    page.wait("return document.querySelector('#detail h2')?.lastChild.textContent === 'features/sphere.ray'")


@test
def several_renderers_are_columns(page, folder):
    page.load(folder / "two.html")
    heads = page.texts(".matrix thead .renderer")
    assert heads == ["trace", "./student -r {depth} {scene} {out}"], heads
    assert len(page.all(".matrix tbody tr")) == 13
    row = page.one(".matrix tr[data-scene='features/refraction.ray']")
    assert [cell.get_attribute("class") for cell in row.find_elements("tag name", "td")] == ["passed", "failed"]
    assert "timed out" in row.text
    page.run("arguments[0].querySelectorAll('a')[1].click()", row)
    page.wait("return document.getElementById('detail').open")
    assert "timed out" in page.one("#detail").text
    assert len(page.all(".renderers a")) == 2
    page.escape()
    page.screenshot(folder / "two.png")
    page.one("[aria-label=Form] [data-value=list]").click()
    assert len(rows(page)) == 26
    page.run("""const pick = document.querySelector(".toolbar select"); pick.value = "trace";
        pick.dispatchEvent(new Event("change"))""")
    assert len(rows(page)) == 13 and set(column(page, "Renderer")) == {"trace"}


@test
def pictures_beside_the_page_are_shown(page, folder):
    page.load(folder / "linked.html")
    open_scene(page, "showcase/still_life.ray")
    pictures_shown(page, 2)
    crops_drawn(page, "showcase/still_life.ray")


@test
def dark_and_light_follow_the_system_until_chosen(page, folder):
    background = lambda: page.run("return getComputedStyle(document.body).backgroundColor")
    shades = {}
    for scheme in ("light", "dark"):
        page.emulate(prefers_color_scheme=scheme)
        page.load(folder / "one.html")
        shades[scheme] = background()
        page.screenshot(folder / f"{scheme}.png")
    assert shades["light"] != shades["dark"], shades
    page.one("[aria-label=Colours] [data-value=light]").click()
    assert background() == shades["light"]
    page.one("[aria-label=Colours] [data-value=dark]").click()
    page.emulate(prefers_color_scheme="light")
    assert background() == shades["dark"]
    page.one("[aria-label=Colours] [data-value=system]").click()
    assert background() == shades["light"]


@test
def a_telephone_shows_it_without_scrolling_sideways(page, folder):
    page.size(360, 740)
    page.load(folder / "one.html")
    wide = "return [document.documentElement.scrollWidth, document.documentElement.clientWidth]"
    assert page.run(wide) == [360, 360], page.run(wide)
    page.screenshot(folder / "narrow.png")
    open_scene(page, "showcase/still_life.ray")
    pictures_shown(page, 2)
    inside = page.run("const d = document.getElementById('detail'); return [d.scrollWidth, d.clientWidth]")
    assert inside[0] <= inside[1], inside
    page.screenshot(folder / "narrow_detail.png")


@test
def pictures_far_away_are_not_decoded(page, folder):
    page.size(1400, 300)
    page.load(folder / "one.html")
    made = page.run("return document.querySelectorAll('.thumb img').length")
    wanted = page.run("return document.querySelectorAll('.thumb').length")
    assert made < wanted, (made, wanted)
    page.run("scrollTo(0, document.body.scrollHeight)")
    page.wait("return document.querySelectorAll('.thumb img').length > arguments[0]", made)


if __name__ == "__main__":
    browser.main(TESTS)
