package lightning.editor.window;

import lightning.base.text.Texts;
import lightning.editor.window.command.Notices;

/** What the program is, for the Help menu. */
final class About {
    private About() {}

    static void show(Notices notices) {
        notices.text("Lightning", Texts.of("Relights ray-traced scenes exactly, in a fraction of a full trace.\n\n"
                + "It traces a scene once, keeps what every pixel needs, and after an edit of a light computes only what "
                + "changed. After \u201cLightning\u201d, Brown University CS-98-09, 1998."));
    }
}
