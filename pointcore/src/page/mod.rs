//! The frame of a page beside a report: one HTML file that needs nothing besides, in light and dark, wide and narrow.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use std::fmt::{Display, Write as _};

/// A page in the making.
#[derive(Clone, Debug, Default)]
pub struct Page {
    title: String,
    body: String,
    styles: String,
    data: Vec<(&'static str, String)>,
    scripts: Vec<&'static str>,
}

/// A line of a chart of bars.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// What it is.
    pub name: String,
    /// How long it is, as a share of the chart's width.
    pub share: f64,
    /// Its figure, in words.
    pub figure: String,
    /// Whether it stands out.
    pub is_marked: bool,
}

/// Text as it stands in HTML.
#[must_use]
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A PNG as the address of itself.
#[must_use]
pub fn embedded(png: &[u8]) -> String {
    "data:image/png;base64,".to_owned() + &STANDARD.encode(png)
}

impl Page {
    /// A page with nothing but a title.
    #[must_use]
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), ..Self::default() }
    }

    /// Figures at a glance, each with what it is.
    #[must_use]
    pub fn figures(mut self, figures: &[(&str, String)]) -> Self {
        self.body += "<dl class=\"figures\">\n";
        for (name, figure) in figures {
            _ = writeln!(self.body, "<div><dd>{}</dd><dt>{}</dt></div>", escape(figure), escape(name));
        }
        self.body += "</dl>\n";
        self
    }

    /// A part of the page in HTML, under a heading, with a sentence on what it shows.
    #[must_use]
    pub fn section(mut self, heading: &str, sentence: &str, html: &str) -> Self {
        let (heading, sentence) = (escape(heading), escape(sentence));
        _ = writeln!(self.body, "<section>\n<h2>{heading}</h2>\n<p>{sentence}</p>\n{html}\n</section>");
        self
    }

    /// Rules of a style sheet for what this page alone has.
    #[must_use]
    pub fn style(mut self, css: &str) -> Self {
        self.styles += css;
        self
    }

    /// Data for a script, which finds them as JSON by their name.
    #[must_use]
    pub fn data(mut self, name: &'static str, json: impl Display) -> Self {
        // What ends a script may not stand in one.
        self.data.push((name, json.to_string().replace("</", "<\\/")));
        self
    }

    /// A script that runs when all of the page is there.
    #[must_use]
    pub fn script(mut self, script: &'static str) -> Self {
        self.scripts.push(script);
        self
    }

    /// The file.
    #[must_use]
    pub fn html(&self) -> String {
        let title = escape(&self.title);
        let mut html = format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{title}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n{}</main>\n",
            include_str!("page.css"),
            self.styles,
            self.body
        );
        for (name, json) in &self.data {
            _ = writeln!(html, "<script type=\"application/json\" id=\"{name}\">{json}</script>");
        }
        for script in &self.scripts {
            _ = writeln!(html, "<script>\n{script}</script>");
        }
        html + "</body>\n</html>\n"
    }
}

/// A chart of bars, one below the other.
#[must_use]
pub fn bars(bars: &[Bar]) -> String {
    let mut html = "<div class=\"bars\">\n".to_owned();
    for Bar { name, share, figure, is_marked } in bars {
        let class = if *is_marked { " class=\"marked\"" } else { "" };
        let width = 100.0 * share.clamp(0.0, 1.0);
        let (name, figure) = (escape(name), escape(figure));
        _ = writeln!(
            html,
            "<div{class}><span>{name}</span><span class=\"track\"><i style=\"width:{width:.2}%\"></i></span><b>{figure}</b></div>"
        );
    }
    html + "</div>"
}

/// A table of names and values.
#[must_use]
pub fn table(rows: &[(String, String)]) -> String {
    let row =
        |(name, value): &(String, String)| format!("<tr><th>{}</th><td>{}</td></tr>\n", escape(name), escape(value));
    format!("<table>\n{}</table>", rows.iter().map(row).collect::<String>())
}

/// A table with heads, of numbers but for its first column; what is too wide for the page scrolls in it.
#[must_use]
pub fn grid<T: AsRef<[String]>>(heads: &[&str], rows: &[T]) -> String {
    columns("numbers", heads, rows)
}

/// A table with heads, of text.
#[must_use]
pub fn grid_of_text<T: AsRef<[String]>>(heads: &[&str], rows: &[T]) -> String {
    columns("text", heads, rows)
}

fn columns<T: AsRef<[String]>>(class: &str, heads: &[&str], rows: &[T]) -> String {
    let head: String = heads.iter().map(|head| format!("<th>{}</th>", escape(head))).collect();
    let mut html =
        format!("<div class=\"scroll\"><table class=\"{class}\">\n<thead><tr>{head}</tr></thead>\n<tbody>\n");
    for row in rows {
        let cells: String = row.as_ref().iter().map(|cell| format!("<td>{}</td>", escape(cell))).collect();
        _ = writeln!(html, "<tr>{cells}</tr>");
    }
    html + "</tbody>\n</table></div>"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_is_one_file_in_which_nothing_breaks_out() {
        let html = Page::new("a < b")
            .figures(&[("cycles & more", "12".to_owned())])
            .section(
                "Time",
                "Where it goes.",
                &bars(&[Bar { name: "<x>".into(), share: 2.0, figure: "9".into(), is_marked: true }]),
            )
            .section("All", "", &table(&[("a".into(), "<b>".into())]))
            .data("points", "[\"</script>\"]")
            .script("run();\n")
            .html();
        assert!(html.contains("<title>a &lt; b</title>") && html.contains("cycles &amp; more"));
        assert!(html.contains("&lt;x&gt;") && html.contains("width:100.00%") && html.contains("class=\"marked\""));
        assert!(html.contains("[\"<\\/script>\"]") && html.contains("<td>&lt;b&gt;</td>"));
        assert!(!html.contains("http"), "it needs nothing besides");
    }

    #[test]
    fn a_grid_has_its_cells_and_a_picture_is_its_own_address() {
        let html = grid(&["unit", "<busy>"], &[["a".to_owned(), "1 & 2".to_owned()]]);
        assert!(html.contains("<th>&lt;busy&gt;</th>") && html.contains("<tr><td>a</td><td>1 &amp; 2</td></tr>"));
        assert_eq!(embedded(b"abc"), "data:image/png;base64,YWJj");
    }
}
