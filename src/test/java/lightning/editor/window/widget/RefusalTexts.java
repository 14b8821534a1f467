package lightning.editor.window.widget;

import java.util.List;
import javafx.scene.control.Label;
import org.testfx.api.FxRobot;

/** The reasons that stand below fields whose text was refused. */
public final class RefusalTexts {
    private RefusalTexts() {}

    /** Those that can be seen, from above. */
    public static List<String> shown(FxRobot robot) {
        return robot.lookup(".refusal").queryAllAs(Label.class).stream().filter(Label::isVisible).map(Label::getText).toList();
    }
}
