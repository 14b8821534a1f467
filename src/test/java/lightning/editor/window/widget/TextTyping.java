package lightning.editor.window.widget;

import javafx.scene.control.TextField;
import org.testfx.api.FxRobot;

/** Types into text fields without moving the mouse. */
public final class TextTyping {
    private TextTyping() {}

    /** Focuses a field and replaces its text without pressing Enter. */
    public static FxRobot replace(FxRobot robot, TextField field, String text) {
        robot.interact(() -> {
            field.requestFocus();
            field.selectAll();
        });
        return robot.write(text);
    }
}
