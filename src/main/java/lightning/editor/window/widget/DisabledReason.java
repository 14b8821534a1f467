package lightning.editor.window.widget;

import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.control.Tooltip;

/**
 * Disables a control and says why. A disabled control hears no mouse, so its tooltip is that of what stands around it.
 */
public final class DisabledReason {
    private final Node wrapper;
    private final Node control;
    private final String hint;
    /** Null before there is anything to say: it is a window, which takes its time, and most controls never need one. */
    private Tooltip tooltip;
    private boolean isInstalled;
    /** What was set last; null before the first. */
    private Optional<String> reason;

    /** Of a control that needs no hint while it is enabled. */
    public DisabledReason(Node wrapper, Node control) {
        this(wrapper, control, "");
    }

    /** @param hint what the tooltip says while the control is enabled; may be empty */
    public DisabledReason(Node wrapper, Node control, String hint) {
        this.wrapper = wrapper;
        this.control = control;
        this.hint = hint;
        set(Optional.empty());
    }

    /** Disables the control with a reason, a clause; or enables it. */
    public void set(Optional<String> newReason) {
        if (!newReason.equals(reason)) {
            reason = newReason;
            show();
        }
    }

    private void show() {
        if (control.isDisable() != reason.isPresent()) {
            setHelpOfParts(reason.map(DisabledReason::capitalize).orElse(""));
        }
        control.setDisable(reason.isPresent());
        String text = reason.map(r -> hint.isEmpty() ? capitalize(r) : hint + "\n" + capitalize(r)).orElse(hint);
        control.setAccessibleHelp(text);
        if (!text.isEmpty()) {
            showTooltip(text);
        } else if (isInstalled) {
            Tooltip.uninstall(wrapper, tooltip);
            isInstalled = false;
        }
    }

    private void showTooltip(String text) {
        tooltip = tooltip == null ? new Tooltip() : tooltip;
        tooltip.setText(text);
        if (!isInstalled) {
            Tooltip.install(wrapper, tooltip);
            isInstalled = true;
        }
    }

    /** A screen reader tells of the part that it is at, and not of the whole. */
    private void setHelpOfParts(String help) {
        control.lookupAll("*").stream().filter(part -> part != control && part.isFocusTraversable())
                .forEach(part -> part.setAccessibleHelp(help));
    }

    private static String capitalize(String clause) {
        return Character.toUpperCase(clause.charAt(0)) + clause.substring(1);
    }
}
