package lightning.editor.window;

import lightning.base.text.Messages;
import lightning.editor.window.command.EditorDialogs;

/** About dialog of the Help menu. */
final class AboutDialog {
    private AboutDialog() {}

    static void show(EditorDialogs notices) {
        notices.showText("Lightning", Messages.tr("Relights ray-traced scenes exactly, in a fraction of the time of a full render.\n\n"
                + "Lightning traces a scene once and caches the shading data of every pixel. After an edit to a light, "
                + "it recomputes only what changed. Based on “Lightning”, Brown University CS-98-09, 1998."));
    }
}
