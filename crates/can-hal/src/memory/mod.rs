//! Plans of message memory: where each section lies, checked before the controller sees it.
