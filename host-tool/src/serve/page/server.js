// Requests to the server that this page came from, with the token it was opened by.
const token = new URLSearchParams(location.search).get("token");
export const url = (path) => path + (token ? "?token=" + encodeURIComponent(token) : "");

/** Address of a certificate, with the day of issue and the name that the form states. */
export function certificate(path) {
  const stated = ["issued", "approved_by"].map((id) => [id, document.getElementById(id).value.trim()]);
  const query = new URLSearchParams([["token", token], ...stated].filter(([, value]) => value)).toString();
  return path + (query ? "?" + query : "");
}

/** Sends JSON; returns what went wrong, or nothing. */
export async function post(path, body) {
  try {
    const answer = await fetch(url(path), {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(body || {}),
    });
    return answer.ok ? "" : await answer.text();
  } catch (error) {
    return "the server does not answer: " + error.message;
  }
}

/** A JSON answer; nothing when there is none. */
export async function load(path) {
  try {
    const answer = await fetch(url(path));
    return answer.ok ? await answer.json() : null;
  } catch {
    return null;
  }
}

/** Has what a link names issued, and saves it; returns why it cannot be had, or nothing. */
export async function save(link) {
  try {
    const answer = await fetch(link.href, { method: "POST", headers: { "Content-Type": "application/json" }, body: "{}" });
    if (!answer.ok) return await answer.text();
    const name = /filename="(.*)"/.exec(answer.headers.get("Content-Disposition"));
    const file = document.createElement("a");
    file.href = URL.createObjectURL(await answer.blob());
    file.download = name ? name[1] : "certificate";
    file.click();
    setTimeout(() => URL.revokeObjectURL(file.href), 60000);
    return "";
  } catch (error) {
    return "the server does not answer: " + error.message;
  }
}
