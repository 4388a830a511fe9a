//! The viewer in English.

mod help;
mod lists;
mod messages;
mod panes;

use crate::report::language::viewer::Viewer;

pub(super) const VIEWER: Viewer = Viewer {
    status: panes::STATUS,
    panes: panes::PANES,
    lists: lists::LISTS,
    help: help::HELP,
    messages: messages::MESSAGES,
    quiz: messages::QUIZ,
    breakpoints: messages::BREAKPOINTS,
    commands: messages::COMMANDS,
};
