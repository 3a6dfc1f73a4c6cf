// One result, over the page. It is open while the page's address names it. A page has addressOf(result), the map
// resultsByAddress and fillDetail(result), which fills `detail` and may push to `leaving` what is to be done when it goes.

const detail = document.getElementById("detail");
let opened = null;  // the result

const leaving = [];  // functions

function leaveDetail() {
  if (stage) stage.close();
  stage = null;
  for (const leave of leaving.splice(0)) leave();
}

function showDetail(result) {
  leaveDetail();
  opened = result;
  fillDetail(result);
  if (!detail.open) detail.showModal();
  document.getElementById("detail-name").focus();
}

function closeDetail() {
  if (detail.open) detail.close();
}

// However it was closed, by Escape too: the address no longer names it, and its row is where one was.
// Unless by now another has been asked for.
detail.addEventListener("close", () => {
  if (detail.open) return;
  leaveDetail();
  detail.replaceChildren();
  if (opened && location.hash === addressOf(opened))
    history.replaceState(null, "", location.pathname + location.search);
  const link = opened && document.querySelector(`#results a[href="${CSS.escape(addressOf(opened))}"]`);
  opened = null;
  if (link) link.focus();
});

function followAddress() {
  const result = resultsByAddress.get(location.hash);
  if (result && result === opened) return;
  if (result) showDetail(result);
  else if (opened) closeDetail();
}
