package lightning.editor.window.animation;

import java.util.Optional;
import lightning.base.text.Messages;
import lightning.editor.document.StepRange;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.NumberSetting;
import lightning.scene.value.SceneLimits;

/** Field for a positive integer that is part of a window and not of a document. */
final class IntegerField {
    private final ArrowWidget widget;
    private int value;

    IntegerField(String id, String label, String title, int max, int initial) {
        widget = new ArrowWidget(label, title, NumberSetting.of(title, new StepRange(1, 1, max), (v, gesture) -> {
            double rounded = gesture == null ? v : Math.rint(v);
            try {
                SceneLimits.checkRange(title, rounded, 1, max);
            } catch (IllegalArgumentException e) {
                return Optional.of(String.valueOf(e.getMessage()));
            }
            if (rounded != Math.rint(rounded)) {
                return Optional.of(Messages.tr("{0}: expected a whole number, found {1}", title, SceneLimits.format(rounded)));
            }
            set((int) rounded);
            return Optional.empty();
        }));
        widget.setId(id);
        set(initial);
    }

    ArrowWidget widget() {
        return widget;
    }

    int get() {
        return value;
    }

    void set(int v) {
        value = v;
        widget.show(v);
    }
}
