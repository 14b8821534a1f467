package lightning.editor.window;

import lightning.base.text.Messages;
import lightning.editor.window.command.EditorDialogs;

/** What the program is, for the Help menu. */
final class AboutDialog {
    private AboutDialog() {}

    static void show(EditorDialogs notices) {
        notices.showText("Lightning", Messages.tr("Relights ray-traced scenes exactly, in a fraction of a full trace.\n\n"
                + "It traces a scene once, keeps what every pixel needs, and after an edit of a light computes only what "
                + "changed. After \u201cLightning\u201d, Brown University CS-98-09, 1998."));
    }
}
