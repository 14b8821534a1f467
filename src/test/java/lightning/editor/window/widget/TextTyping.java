package lightning.editor.window.widget;

import javafx.scene.control.TextField;
import org.testfx.api.FxRobot;

/** Typing over what a field holds, without the way of the mouse to it. */
public final class TextTyping {
    private TextTyping() {}

    /** Focuses a field and types in place of its text; Enter is left to the caller. */
    public static FxRobot replace(FxRobot robot, TextField field, String text) {
        robot.interact(() -> {
            field.requestFocus();
            field.selectAll();
        });
        return robot.write(text);
    }
}
