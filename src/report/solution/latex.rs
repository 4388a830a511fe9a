//! A worked solution for pdflatex, with what a standard distribution has: amsmath, longtable and TikZ.

use super::figures::caption;
use super::format::{self, Around, Format};
use super::math::{self, Tex};
use super::{Kind, Section, Task};
use crate::report::escape;
use crate::report::ray_group::RayGroup;
use crate::report::ray_tree::{self, Figure};
use crate::report::schematic::{self, Plan};

/// The packages.
const PREAMBLE: &str = r"\documentclass[10pt,a4paper,fleqn]{article}
\usepackage[utf8]{inputenc}
\usepackage[margin=2cm]{geometry}
\usepackage{amsmath}
\usepackage{array}
\usepackage{longtable}
\usepackage{tikz}
";
/// What comes between the colours of rays and the text. A figure that is wider than the page is made to fit.
const SETTINGS: &str = r"\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt}
\setlength{\mathindent}{1.5em}
\setlength{\emergencystretch}{3em}
\allowdisplaybreaks
\raggedright
\AtBeginDocument{\setlength{\abovedisplayskip}{3pt}\setlength{\belowdisplayskip}{5pt}%
  \setlength{\abovedisplayshortskip}{3pt}\setlength{\belowdisplayshortskip}{5pt}}
\newcolumntype{P}[1]{>{\raggedright\arraybackslash}p{#1}}
\newsavebox{\drawing}
\newcommand{\drawn}{\begin{center}\ifdim\wd\drawing>\linewidth
  \resizebox{\linewidth}{!}{\usebox{\drawing}}\else\usebox{\drawing}\fi\end{center}}
\newcommand{\fitted}[1]{\sbox{\drawing}{$\displaystyle #1$}\ifdim\wd\drawing>0.9\linewidth
  \resizebox{0.9\linewidth}{!}{\usebox{\drawing}}\else\usebox{\drawing}\fi}
\newcommand{\step}[2]{\par\medskip\textbf{#1) #2}\nopagebreak}
\newcommand{\parttitle}[1]{\par\smallskip\textit{#1}\nopagebreak}
\begin{document}
";

/// The beginning of the table of what adds to the colour.
const TABLE: &str = r"{\scriptsize\setlength{\tabcolsep}{3pt}\renewcommand{\arraystretch}{1.25}
\begin{longtable}{P{2cm}P{2.5cm}P{1.8cm}P{3.4cm}P{1.6cm}P{3.4cm}r}
";

/// The worked solution of a log.
pub fn latex(task: &Task) -> String {
    format::page::<Latex>(task)
}

struct Latex;

impl Format for Latex {
    type Formulas = Tex;
    const HEADING: Around = [r"\subsection*{", "}\n"];
    const PARAGRAPH: Around = ["", "\n\n"];
    const GROUP: [&str; 3] = [r"\textbf{", ":} ", "\n\n"];
    // No empty line follows: a formula behind it would begin a paragraph of its own.
    const GIVEN: Around = [r"\par ", ":\n"];
    const ASSIGNMENT: Around = ["$", "$"];
    const DECISION: Around = [r"\par $\rightarrow$ ", "\n"];
    const BACK: Around = [r"\subsubsection*{", "}\n"];
    const LIST: [&str; 3] = ["", ":\n\\begin{itemize}\\setlength{\\itemsep}{0pt}\n", "\\end{itemize}\n"];
    const ITEM: Around = [r"\item ", "\n"];
    const END: &str = "\n\\end{document}\n";

    fn escaped(text: &str) -> String {
        escape::latex(text)
    }

    fn begin(_task: &Task, title: &str) -> String {
        let color =
            |group: RayGroup| format!("\\definecolor{{{}}}{{HTML}}{{{}}}\n", group.word(), group.hex().to_uppercase());
        format!("{PREAMBLE}{}{SETTINGS}\\section*{{{title}}}\n", RayGroup::ALL.map(color).concat())
    }

    fn ray_tree(task: &Task, figure: &Figure) -> String {
        let width = escape::latex(task.language.texts().figure.width);
        format!("{}\\begin{{center}}\\small {width}\\end{{center}}\n\n", drawn(&ray_tree::tikz(figure)))
    }

    fn schematic(task: &Task, plan: &Plan) -> String {
        format!("\\subsection*{{{}}}\n{}", escape::latex(&caption(task, plan)), drawn(&schematic::tikz(plan)))
    }

    fn open(_task: &Task, section: &Section, title: &str) -> String {
        match section.kind {
            Kind::Ray => format!("\\subsubsection*{{{title}}}\n"),
            Kind::Step(number) => format!("\\step{{{number}}}{{{title}}}\n"),
            Kind::Part => format!("\\parttitle{{{title}}}\n"),
        }
    }

    fn equations(task: &Task, events: &[usize]) -> String {
        let lines = math::aligned(task, events, |formula| format!("\\fitted{{{formula}}}"));
        format!("\\begin{{align*}}\n{}\n\\end{{align*}}\n", lines.join(" \\\\\n"))
    }

    fn table(columns: &[String; 7], rows: &[[String; 7]]) -> String {
        let row = |cells: &[String; 7]| format!("{} \\\\", cells.join(" & "));
        let mut lines: Vec<_> = rows.iter().map(row).collect();
        // The last is the sum.
        if let Some(last) = lines.last_mut() {
            last.insert_str(0, "\\hline ");
        }
        format!("{TABLE}{} \\hline \\endhead\n{}\n\\end{{longtable}}}}\n", row(columns), lines.join("\n"))
    }
}

/// A figure that is made to fit.
fn drawn(drawing: &str) -> String {
    format!("\\begin{{lrbox}}{{\\drawing}}\n{drawing}\\end{{lrbox}}\\drawn\n")
}
