//! A plot as SVG that needs no script, font or network: it prints, and goes into a PDF.
//!
//! Zooming is an affine map of positions, because a logarithmic axis is linear
//! on paper. A drawing that can be zoomed carries, hidden, the finer ticks that
//! a reader may zoom to, and every position once more as data; a page's script
//! moves and shows what is there.

use crate::{Axis, Ink, Mark, Plot, Point, Scale, Shape, ticks::Tick};
use std::fmt::Write;

const WIDTH: f64 = 760.0;
const RIGHT: f64 = 700.0;
const TOP: f64 = 26.0;
/// Room for the numbers and the title of the horizontal axis.
const BELOW: f64 = 44.0;

/// A circle of radius 3 as curves, 0.03 % from round: who draws a `circle` asks the platform for a
/// cosine, and certificates would differ in the last digits of a zero.
const CIRCLE: &str = "M3,0C3,1.657,1.657,3,0,3S-3,1.657,-3,0,-1.657,-3,0,-3,3,-1.657,3,0Z";

/// Inline style, so that the drawing stands alone.
const STYLE: &str = "\
.plot text{font:11px 'Liberation Sans','Helvetica Neue',Arial,sans-serif;fill:#333}\
.plot .grid{stroke:#d9dde2;stroke-width:1}.plot .minor{stroke:#eef0f2;stroke-width:1}\
.plot .frame{fill:none;stroke:#555;stroke-width:1}.plot .line{fill:none;stroke:#1f5fa8;stroke-width:1.6}\
.plot .band{fill:#2e7d32;fill-opacity:.09}.plot .limit{fill:none;stroke:#2e7d32;stroke-width:1.1;stroke-dasharray:6 3}.plot .own{stroke-width:2;stroke-dasharray:none}.plot .bar{stroke:#1f5fa8;stroke-width:1.2;fill:none}.plot .dot{fill:#1f5fa8}\
.plot .reference{fill:#fff;stroke:#1f5fa8;stroke-width:2}.plot .refused{stroke:#b3261e;stroke-width:1.8}\
.plot .mid{text-anchor:middle}.plot .end{text-anchor:end}.plot .fine{display:none}";

impl Plot {
    /// The drawing; `id` must be unlike any other in the same document.
    ///
    /// Marks outside the frame are cut off, those that are not finite left out.
    #[must_use]
    pub fn svg(&self, id: &str) -> String {
        Drawing::of(self).finish(id, "")
    }

    /// Style of inks beyond the usual ones, if any is used.
    fn inks(&self) -> String {
        let used = |ink: Ink| self.marks.iter().any(|mark| ink_of(mark) == Some(ink));
        let mut style = String::new();
        for (ink, color, width) in [
            (Ink::Red, "#b5331d", 1.6),
            (Ink::Grey, "#8a8a8a", 0.8),
            (Ink::Green, "#2c7a4b", 0.8),
        ] {
            if used(ink) {
                let n = class(ink);
                let _ = write!(
                    style,
                    ".plot .line{n},.plot .bar{n},.plot .reference{n},.plot .limit{n}{{stroke:{color}}}\
                     .plot .line{n}{{stroke-width:{width}}}.plot .dot{n},.plot .band{n}{{fill:{color}}}",
                    n = n.replace(' ', ".")
                );
            }
        }
        style
    }
}

/// Pictures of a document of its own, in rows of `columns`, on white.
#[must_use]
pub fn sheet(plots: &[Plot], columns: usize) -> String {
    let columns = columns.max(1);
    let mut pictures = String::new();
    let mut top = 0.0;
    for (row, plots) in plots.chunks(columns).enumerate() {
        for (column, plot) in plots.iter().enumerate() {
            let left = WIDTH * column as f64;
            let place = format!(
                " x='{left}' y='{top}' width='{WIDTH}' height='{}'",
                plot.height
            );
            pictures += &Drawing::of(plot).finish(&format!("plot-{row}-{column}"), &place);
        }
        top += plots.iter().map(|plot| plot.height).fold(0.0, f64::max);
    }
    let width = WIDTH * columns.min(plots.len().max(1)) as f64;
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width} {top}' width='{width}' height='{top}'>\
         <rect width='100%' height='100%' fill='#fff'/>{pictures}</svg>\n"
    )
}

/// Class of an ink after that of a mark; the usual one has none.
fn class(ink: Ink) -> &'static str {
    match ink {
        Ink::Blue => "",
        Ink::Red => " red",
        Ink::Grey => " grey",
        Ink::Green => " green",
    }
}

fn ink_of(mark: &Mark) -> Option<Ink> {
    match mark {
        Mark::Line { ink, .. }
        | Mark::Points { ink, .. }
        | Mark::Band { ink, .. }
        | Mark::Bars { ink, .. } => Some(*ink),
        Mark::Limits { .. } | Mark::Missing { .. } | Mark::Words { .. } => None,
    }
}

/// A drawing under construction.
struct Drawing<'a> {
    plot: &'a Plot,
    left: f64,
    bottom: f64,
    body: String,
}

impl<'a> Drawing<'a> {
    fn of(plot: &'a Plot) -> Self {
        let mut drawing = Self {
            plot,
            left: plot.left,
            bottom: plot.height - BELOW,
            body: String::new(),
        };
        drawing.x_ticks();
        drawing.y_ticks();
        if let Some(axis) = &plot.right {
            drawing.right_ticks(axis);
        }
        drawing
    }

    /// Adds frame and marks; `place` are attributes of a drawing inside another.
    fn finish(mut self, id: &str, place: &str) -> String {
        let axes = std::mem::take(&mut self.body);
        for mark in &self.plot.marks {
            self.mark(mark);
        }
        let (left, bottom, height) = (self.left, self.bottom, self.plot.height);
        let caption = escape(&self.plot.caption);
        let label = caption.replace('\'', "&#39;");
        let inks = self.plot.inks();
        let rectangle = format!(
            "x='{left}' y='{TOP}' width='{}' height='{}'/>",
            RIGHT - left,
            bottom - TOP
        );
        format!(
            "<svg xmlns='http://www.w3.org/2000/svg'{place} class='plot' viewBox='0 0 {WIDTH} {height}' \
             role='img' aria-label='{label}' data-area='{left} {TOP} {RIGHT} {bottom}'><style>{STYLE}{inks}</style>\
             <defs><clipPath id='{id}'><rect {rectangle}</clipPath></defs>\
             <text x='{left}' y='14'>{caption}</text>{axes}<g clip-path='url(#{id})'>{}</g>\
             <rect class='frame' {rectangle}<text class='mid' x='{}' y='{}'>{}</text></svg>",
            self.body,
            (left + RIGHT) / 2.0,
            height - 8.0,
            escape(&self.plot.x.title),
        )
    }

    fn x(&self, value: f64) -> Option<f64> {
        let fraction = self.plot.x.fraction(value)?;
        Some(self.left + fraction * (RIGHT - self.left))
    }

    fn on(&self, axis: &Axis, value: f64) -> Option<f64> {
        let fraction = axis.fraction(value)?;
        Some(self.bottom - fraction * (self.bottom - TOP))
    }

    fn place(&self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        Some((self.x(x)?, self.on(&self.plot.y, y)?))
    }

    /// Ticks with their places; the finest only where a reader can zoom to them.
    fn ticks(&self, axis: &Axis) -> Vec<Tick> {
        let most = match axis.scale {
            _ if self.plot.zoom => 2,
            Scale::Logarithmic => 1,
            _ => 0,
        };
        let mut ticks = axis.ticks();
        ticks.retain(|tick| tick.level <= most);
        ticks
    }

    fn x_ticks(&mut self) {
        let axis = &self.plot.x;
        for tick in &self.ticks(axis) {
            let Some(at) = self.x(tick.value) else {
                continue;
            };
            let (line, text) = classes(axis, tick.level, "mid");
            let _ = write!(
                self.body,
                "<g class='tick' data-x='{at:.2}' data-level='{}' transform='translate({at:.2},0)'>\
                 <line class='{line}' y1='{TOP}' y2='{}'/><text class='{text}' y='{}'>{}</text></g>",
                tick.level,
                self.bottom,
                self.bottom + 16.0,
                words(tick, axis, self.plot.decimal_sign),
            );
        }
    }

    fn y_ticks(&mut self) {
        let axis = &self.plot.y;
        for tick in &self.ticks(axis) {
            let Some(at) = self.on(axis, tick.value) else {
                continue;
            };
            let (line, text) = classes(axis, tick.level, "end");
            let _ = write!(
                self.body,
                "<g class='tick' data-y='{at:.2}' data-level='{}' transform='translate(0,{at:.2})'>\
                 <line class='{line}' x1='{}' x2='{RIGHT}'/>\
                 <text class='{text}' x='{}' y='4'>{}</text></g>",
                tick.level,
                self.left,
                self.left - 6.0,
                words(tick, axis, self.plot.decimal_sign),
            );
        }
    }

    fn right_ticks(&mut self, axis: &Axis) {
        for tick in &self.ticks(axis) {
            let Some(at) = self.on(axis, tick.value) else {
                continue;
            };
            let fine = if tick.level == 0 { "" } else { " class='fine'" };
            let _ = write!(
                self.body,
                "<g class='tick' data-y='{at:.2}' data-level='{}' transform='translate(0,{at:.2})'>\
                 <text{fine} x='{}' y='4'>{}</text></g>",
                tick.level,
                RIGHT + 6.0,
                words(tick, axis, self.plot.decimal_sign),
            );
        }
        let _ = write!(
            self.body,
            "<text class='end' x='{}' y='14'>{}</text>",
            WIDTH - 4.0,
            escape(&axis.title)
        );
    }

    fn mark(&mut self, mark: &Mark) {
        match mark {
            Mark::Line { points, ink } => {
                let places = self.listed(points.iter().copied());
                self.shape("polyline", &format!("line{}", class(*ink)), &places);
            }
            Mark::Points { points, ink } => points.iter().for_each(|p| self.point(p, class(*ink))),
            Mark::Band { places, ink } => self.band(places, class(*ink)),
            Mark::Limits { x, limits } => limits.iter().for_each(|limit| self.limit(*x, *limit)),
            Mark::Missing { x, title } => self.missing(*x, title),
            Mark::Bars { bars, ink } => bars.iter().for_each(|bar| self.bar(*bar, class(*ink))),
            Mark::Words { at, text } => self.text(*at, text),
        }
    }

    fn listed(&self, points: impl Iterator<Item = (f64, f64)>) -> Vec<String> {
        let placed = points.filter_map(|point| self.place(point));
        placed.map(|(x, y)| format!("{x:.2},{y:.2}")).collect()
    }

    fn shape(&mut self, element: &str, class: &str, places: &[String]) {
        let places = places.join(" ");
        if self.plot.zoom {
            let _ = write!(
                self.body,
                "<{element} class='{class}' data-points='{places}' points='{places}'/>"
            );
        } else {
            let _ = write!(self.body, "<{element} class='{class}' points='{places}'/>");
        }
    }

    fn band(&mut self, places: &[(f64, f64, f64)], ink: &str) {
        let lower = self.listed(places.iter().map(|p| (p.0, p.1)));
        let upper = self.listed(places.iter().map(|p| (p.0, p.2)));
        let outline: Vec<String> = upper.iter().chain(lower.iter().rev()).cloned().collect();
        self.shape("polygon", &format!("band{ink}"), &outline);
        self.shape("polyline", &format!("limit{ink}"), &lower);
        self.shape("polyline", &format!("limit{ink}"), &upper);
    }

    fn limit(&mut self, x: f64, limit: f64) {
        if let Some((x, y)) = self.place((x, limit)) {
            let ends = [-9.0, 9.0].map(|half| format!("{:.2},{y:.2}", x + half));
            self.shape("polyline", "limit own", &ends);
        }
    }

    fn point(&mut self, point: &Point, ink: &str) {
        let Some((x, y)) = self.place((point.x, point.y)) else {
            return;
        };
        let _ = write!(
            self.body,
            "<g class='mark' data-x='{x:.2}' data-y='{y:.2}' transform='translate({x:.2},{y:.2})'>{}",
            title(&point.title)
        );
        let end = point
            .half_bar
            .and_then(|_| self.on(&self.plot.y, point.ends()[0]));
        if let Some(end) = end {
            let half = end - y;
            let _ = write!(
                self.body,
                "<path class='bar{ink}' data-half='{half:.3}' d='M-4,{:.3}h8M0,{:.3}V{half:.3}M-4,{half:.3}h8'/>",
                -half, -half,
            );
        }
        let _ = match point.shape {
            Shape::Dot => write!(self.body, "<path class='dot{ink}' d='{CIRCLE}'/></g>"),
            Shape::Hollow => write!(self.body, "<path class='reference{ink}' d='{CIRCLE}'/></g>"),
            Shape::Cross => write!(self.body, "<path class='bar{ink}' d='M-4,0h8M0,-4v8'/></g>"),
        };
    }

    fn missing(&mut self, x: f64, why: &str) {
        let Some(at) = self.x(x) else { return };
        let _ = write!(
            self.body,
            "<g class='mark' data-x='{at:.2}' transform='translate({at:.2},{})'>{}\
             <path class='refused' d='M-4,-4l8,8M-4,4l8,-8'/></g>",
            self.bottom - 9.0,
            title(why),
        );
    }

    fn bar(&mut self, (y, end): (f64, f64), ink: &str) {
        let Some((x, y)) = self.place((end, y)) else {
            return;
        };
        let _ = write!(
            self.body,
            "<rect class='dot{ink}' x='{}' y='{:.2}' width='{:.2}' height='14'/>",
            self.left,
            y - 7.0,
            (x - self.left).max(0.0),
        );
    }

    fn text(&mut self, at: (f64, f64), text: &str) {
        if let Some((x, y)) = self.place(at) {
            let _ = write!(
                self.body,
                "<g class='mark' data-x='{x:.2}' data-y='{y:.2}' transform='translate({x:.2},{y:.2})'>\
                 <text x='6' y='4'>{}</text></g>",
                escape(text)
            );
        }
    }
}

/// Classes of the line and the number of a tick.
fn classes(axis: &Axis, level: u8, text: &str) -> (&'static str, String) {
    let line = match (&axis.scale, level) {
        (_, 0) => "grid",
        (Scale::Logarithmic, 1) => "minor",
        (Scale::Logarithmic, _) => "minor fine",
        _ => "grid fine",
    };
    let fine = if level == 0 { "" } else { " fine" };
    (line, format!("{text}{fine}"))
}

/// Label of a tick as a printer sets it.
fn words(tick: &Tick, axis: &Axis, decimal_sign: char) -> String {
    match axis.scale {
        Scale::Named(_) => escape(&tick.label),
        _ => tick
            .label
            .replace('-', "\u{2212}")
            .replace('.', &decimal_sign.to_string()),
    }
}

fn title(words: &str) -> String {
    match words {
        "" => String::new(),
        words => format!("<title>{}</title>", escape(words)),
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use quick_xml::events::Event;

    fn plot() -> Plot {
        let x = Axis::new(Scale::Logarithmic, 10.0, 1000.0).titled("f < 1 kHz & more");
        let y = Axis::new(Scale::Linear, 0.0, 2.0);
        let points = vec![
            Point {
                title: "a < b".into(),
                shape: Shape::Hollow,
                ..Point::new(100.0, 1.0).with_bar(0.5)
            },
            Point::new(f64::NAN, 1.0),
            Point {
                shape: Shape::Cross,
                ..Point::new(10.0, 0.0)
            },
        ];
        Plot::new("it's <S>", x, y)
            .with(Mark::Band {
                places: vec![(10.0, 0.5, 1.5), (1000.0, 0.6, 1.4)],
                ink: Ink::Blue,
            })
            .with(Mark::Limits {
                x: 100.0,
                limits: [0.9, 1.1],
            })
            .with(Mark::Line {
                points: vec![(10.0, 0.0), (-1.0, 0.0), (1000.0, 2.0)],
                ink: Ink::Grey,
            })
            .with(Mark::Points {
                points,
                ink: Ink::Red,
            })
            .with(Mark::Missing {
                x: 50.0,
                title: "refused".into(),
            })
            .with(Mark::Words {
                at: (100.0, 1.0),
                text: "here & now".into(),
            })
    }

    /// Elements with their attributes; fails where the text is no well-formed XML.
    fn elements(svg: &str) -> Vec<(String, String)> {
        let mut reader = quick_xml::Reader::from_str(svg);
        reader.config_mut().check_end_names = true;
        let mut found = Vec::new();
        let mut open = 0;
        loop {
            let event = reader.read_event().expect("well-formed");
            match &event {
                Event::Start(start) | Event::Empty(start) => {
                    open += i32::from(matches!(event, Event::Start(_)));
                    let mut attributes = String::new();
                    for attribute in start.attributes() {
                        let attribute = attribute.expect("an attribute with a value, there once");
                        let _ = write!(attributes, "{}|", attribute.value);
                    }
                    let name = start.name().0.to_owned();
                    found.push((name, attributes));
                }
                Event::End(_) => open -= 1,
                Event::Eof => break,
                _ => {}
            }
        }
        assert_eq!(open, 0, "every element is closed");
        found
    }

    #[test]
    fn every_drawing_is_well_formed_and_holds_its_marks() {
        let mut zoomed = plot();
        (zoomed.zoom, zoomed.right) = (
            true,
            Some(Axis::new(Scale::Linear, -100.0, 100.0).titled("in %")),
        );
        let bars = Plot::new(
            "bars",
            Axis::new(Scale::Linear, 0.0, 1.0),
            Axis::named(vec!["a<b".into()]),
        )
        .with(Mark::Bars {
            bars: vec![(0.5, 0.7)],
            ink: Ink::Green,
        });
        for svg in [
            plot().svg("a"),
            zoomed.svg("b"),
            sheet(&[plot(), bars, plot()], 2),
        ] {
            let elements = elements(&svg);
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
            assert!(elements.iter().any(|(name, _)| name == "rect"));
        }
        let drawn = elements(&plot().svg("a"));
        let marks = drawn
            .iter()
            .filter(|(_, values)| values.starts_with("mark|"))
            .count();
        // Two points that are numbers, the missing one, the words.
        assert_eq!(marks, 4);
    }

    /// The middle of two decades and of 0 to 2 is the middle of the frame: 62 to 700 and 26 to 256.
    #[test]
    fn values_stand_where_the_axes_say() {
        let svg = plot().svg("a");
        assert!(svg.contains("data-x='381.00' data-y='141.00'"), "{svg}");
        // A quarter of the frame up and down: half of 0.5 of 2.0.
        assert!(svg.contains("data-half='57.500'"), "{svg}");
        // What cannot be placed is no corner of the line.
        assert!(svg.contains("points='62.00,256.00 700.00,26.00'"), "{svg}");
    }

    #[test]
    fn only_a_drawing_that_zooms_carries_the_finest_ticks() {
        let mut plot = plot();
        let ticks = |plot: &Plot| plot.svg("a").matches("class='tick'").count();
        // 10 to 1000: 2 x 9 + 1; 0 to 2 in steps of 0.5.
        assert_eq!(ticks(&plot), 19 + 5);
        plot.zoom = true;
        // Tenths: 2 x 90 + 1; fiftieths of 0.5: 200 + 1.
        assert_eq!(ticks(&plot), 181 + 201);
    }

    #[test]
    fn numbers_follow_the_language() {
        let mut plot = Plot::new(
            "",
            Axis::new(Scale::Linear, -1.0, 1.0),
            Axis::new(Scale::Linear, 0.0, 1.0),
        );
        plot.decimal_sign = ',';
        assert!(plot.svg("a").contains(">\u{2212}0,5"), "{}", plot.svg("a"));
    }
}
