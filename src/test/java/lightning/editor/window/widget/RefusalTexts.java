package lightning.editor.window.widget;

import java.util.List;
import javafx.scene.control.Label;
import org.testfx.api.FxRobot;

/** Reads the refusal messages below fields. */
public final class RefusalTexts {
    private RefusalTexts() {}

    /** Returns the visible messages from top to bottom. */
    public static List<String> shown(FxRobot robot) {
        return robot.lookup(".refusal").queryAllAs(Label.class).stream().filter(Label::isVisible).map(Label::getText).toList();
    }
}
