package lightning.editor.window.widget;

import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.control.Tooltip;

/**
 * Disables a control and says why. A disabled control hears no mouse, so its tooltip is that of what stands around it.
 */
public final class Obstacle {
    private final Node around;
    private final Node control;
    private final String hint;
    /** Null before there is anything to say: it is a window, which takes its time, and most controls never need one. */
    private Tooltip tooltip;
    private boolean installed;
    /** What was set last; null before the first. */
    private Optional<String> reason;

    /** Of a control that needs no hint while it is enabled. */
    public Obstacle(Node around, Node control) {
        this(around, control, "");
    }

    /** @param hint what the tooltip says while the control is enabled; may be empty */
    public Obstacle(Node around, Node control, String hint) {
        this.around = around;
        this.control = control;
        this.hint = hint;
        set(Optional.empty());
    }

    /** Disables the control with a reason, a clause; or enables it. */
    public void set(Optional<String> now) {
        if (!now.equals(reason)) {
            reason = now;
            show();
        }
    }

    private void show() {
        if (control.isDisable() != reason.isPresent()) {
            tellParts(reason.map(Obstacle::sentence).orElse(""));
        }
        control.setDisable(reason.isPresent());
        String text = reason.map(r -> hint.isEmpty() ? sentence(r) : hint + "\n" + sentence(r)).orElse(hint);
        control.setAccessibleHelp(text);
        if (!text.isEmpty()) {
            tip(text);
        } else if (installed) {
            Tooltip.uninstall(around, tooltip);
            installed = false;
        }
    }

    private void tip(String text) {
        tooltip = tooltip == null ? new Tooltip() : tooltip;
        tooltip.setText(text);
        if (!installed) {
            Tooltip.install(around, tooltip);
            installed = true;
        }
    }

    /** A screen reader tells of the part that it is at, and not of the whole. */
    private void tellParts(String why) {
        control.lookupAll("*").stream().filter(part -> part != control && part.isFocusTraversable())
                .forEach(part -> part.setAccessibleHelp(why));
    }

    private static String sentence(String clause) {
        return Character.toUpperCase(clause.charAt(0)) + clause.substring(1);
    }
}
