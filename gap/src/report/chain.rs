//! The measuring chain as a drawing, with the stages that are suspected.

use std::fmt::Write;

/// Stage, words in the box, place of its middle.
const BOXES: [(&str, &str, f64, f64); 8] = [
    ("amplifier", "power amplifier", 75.0, 75.0),
    ("exciter", "shaker", 225.0, 75.0),
    ("environment", "surroundings", 225.0, 150.0),
    ("mount", "mounting", 375.0, 75.0),
    ("reference", "reference", 525.0, 35.0),
    ("dut", "device under test", 525.0, 115.0),
    ("conditioning", "electronics", 675.0, 75.0),
    ("digitiser", "converter", 825.0, 75.0),
];
const ARROWS: [(f64, f64, f64, f64); 8] = [
    (135.0, 75.0, 165.0, 75.0),
    (285.0, 75.0, 315.0, 75.0),
    (225.0, 132.0, 225.0, 93.0),
    (435.0, 70.0, 465.0, 40.0),
    (435.0, 80.0, 465.0, 110.0),
    (585.0, 40.0, 615.0, 70.0),
    (585.0, 110.0, 615.0, 80.0),
    (735.0, 75.0, 765.0, 75.0),
];

/// Draws the chain; `suspects` are the names of stages.
pub(super) fn chain(suspects: &[&str]) -> String {
    let mut svg = String::from(
        "<svg class=chain viewBox='0 0 900 175' role=img aria-label='measuring chain'>\
         <defs><marker id=tip viewBox='0 0 8 8' refX=7 refY=4 markerWidth=7 markerHeight=7 orient=auto>\
         <path d='M0 0L8 4L0 8z'/></marker></defs>",
    );
    for (x1, y1, x2, y2) in ARROWS {
        let _ = write!(
            svg,
            "<line x1={x1} y1={y1} x2={x2} y2={y2} marker-end='url(#tip)'/>"
        );
    }
    for (stage, words, x, y) in BOXES {
        let class = if suspects.contains(&stage) {
            let _ = write!(svg, "<text class=mark x={x} y={}>here</text>", y - 24.0);
            "suspect"
        } else {
            ""
        };
        let _ = write!(
            svg,
            "<rect class='{class}' x={} y={} width=120 height=36 rx=6 /><text class='{class}' x={x} y={}>{words}</text>",
            x - 60.0,
            y - 18.0,
            y + 5.0,
        );
    }
    svg.push_str("</svg>");
    svg + &narrow(suspects)
}

/// The same as a line of words, for a screen on which the drawing cannot be read.
fn narrow(suspects: &[&str]) -> String {
    let mut list = String::from("<p class=stages>");
    for (stage, words, _, _) in BOXES {
        let _ = if suspects.contains(&stage) {
            write!(list, "<span class=suspect>{words}: here</span> ")
        } else {
            write!(list, "<span>{words}</span> ")
        };
    }
    list + "</p>"
}
