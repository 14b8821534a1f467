package lightning.editor.window.model;

import lightning.base.text.Messages;

/** Place of a panel in the editor. */
public enum PanelPlace {
    LEFT(Messages.key("Left of the Pictures")), BELOW(Messages.key("Below the Pictures")), WINDOW(Messages.key("Own Window"));

    private final String title;

    PanelPlace(String title) {
        this.title = title;
    }

    /** Returns whether the place is a part of the editor's window. */
    public boolean isDock() {
        return this != WINDOW;
    }

    @Override
    public String toString() {
        return Messages.tr(title);
    }
}
