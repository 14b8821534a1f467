package lightning.editor.window.widget;

import static java.util.Objects.requireNonNull;

import java.util.Optional;
import javafx.scene.Node;
import javafx.scene.control.Tooltip;
import org.jspecify.annotations.Nullable;

/**
 * Disables a control and shows the reason in a tooltip. The tooltip belongs to a wrapper node, since a disabled control receives no mouse
 * events.
 */
public final class DisabledReason {
    private final Node wrapper;
    private final Node control;
    private final String hint;
    /** Created on demand: a tooltip is a window, and most controls never show one. */
    private @Nullable Tooltip tooltip;
    private boolean isInstalled;
    /** Current reason; null before the first call. */
    private @Nullable Optional<String> reason;

    /** Creates a reason for a control without a tooltip while enabled. */
    public DisabledReason(Node wrapper, Node control) {
        this(wrapper, control, "");
    }

    /** @param hint  tooltip while the control is enabled; may be empty */
    public DisabledReason(Node wrapper, Node control, String hint) {
        this.wrapper = wrapper;
        this.control = control;
        this.hint = hint;
        set(Optional.empty());
    }

    /** Disables the control with a reason, as a clause, or enables it. */
    public void set(Optional<String> newReason) {
        if (!newReason.equals(reason)) {
            reason = newReason;
            show();
        }
    }

    private void show() {
        if (control.isDisable() != requireNonNull(reason).isPresent()) {
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

    /** Sets the help text of focusable parts, since screen readers describe the focused part only. */
    private void setHelpOfParts(String help) {
        control.lookupAll("*").stream().filter(part -> part != control && part.isFocusTraversable())
                .forEach(part -> part.setAccessibleHelp(help));
    }

    private static String capitalize(String clause) {
        return Character.toUpperCase(clause.charAt(0)) + clause.substring(1);
    }
}
