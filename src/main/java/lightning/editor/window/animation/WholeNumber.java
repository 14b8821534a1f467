package lightning.editor.window.animation;

import java.util.Optional;
import lightning.base.text.Texts;
import lightning.editor.document.Steps;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.Gauge;
import lightning.scene.Limits;

/** A whole number from 1 that belongs to a window and no document. */
final class WholeNumber {
    private final ArrowWidget widget;
    private int value;

    WholeNumber(String id, String label, String title, int max, int first) {
        widget = new ArrowWidget(label, title, Gauge.of(title, new Steps(1, 1, max), (v, gesture) -> {
            double wanted = gesture == null ? v : Math.rint(v);
            try {
                Limits.range(title, wanted, 1, max);
            } catch (IllegalArgumentException e) {
                return Optional.of(e.getMessage());
            }
            if (wanted != Math.rint(wanted)) {
                return Optional.of(Texts.of("{0} must be a whole number, was {1}", title, Limits.text(wanted)));
            }
            set((int) wanted);
            return Optional.empty();
        }));
        widget.setId(id);
        set(first);
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
