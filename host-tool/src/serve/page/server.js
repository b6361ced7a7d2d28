// Requests to the server that this page came from, with the token it was opened by.
import { current, say } from "./words.js";

const token = new URLSearchParams(location.search).get("token");
export const url = (path) => path + (token ? "?token=" + encodeURIComponent(token) : "");

/** What the form states on certificates, by the names the server knows. */
export const stated = ["customer", "ambient_temperature_c", "humidity_percent", "adjustment", "as_found", "substituted", "issued", "approved_by"];

/** Those that are records beside that of the run. */
const beside = ["as_found", "substituted"];

/** Address of a certificate, or of results, with what the form and `more` state on it and the language of the page.
 *  Records beside its own belong to the last run alone. */
export function certificate(path, more = {}) {
  const is_last = !/^api\/(records|amended)/.test(path);
  const values = stated.filter((id) => is_last || !beside.includes(id)).map((id) => [id, document.getElementById(id).value.trim()]);
  const query = new URLSearchParams([["token", token], ["language", current()], ...values, ...Object.entries(more)].filter(([, value]) => value));
  return path + "?" + query;
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
    return say("the server does not answer: {0}", error.message);
  }
}

/** A JSON answer; nothing when there is none. */
export async function load(path) {
  return load_at(url(path));
}

/** The same from a whole address. */
export async function load_at(address) {
  try {
    const answer = await fetch(address);
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
    return say("the server does not answer: {0}", error.message);
  }
}
