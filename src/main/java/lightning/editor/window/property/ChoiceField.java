package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.scene.control.ComboBox;
import javafx.scene.layout.StackPane;
import javafx.util.StringConverter;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.ValueWidget;
import org.jspecify.annotations.Nullable;

/** Combo box for one of several values. */
final class ChoiceField<V> extends StackPane implements ValueWidget<V> {
    private final ComboBox<V> box = new ComboBox<>();
    private final Function<@Nullable V, List<V>> offered;
    private final DisabledReason disabledReason;
    private boolean isUpdating;

    /**
     * @param id       of the box
     * @param title    for screen readers
     * @param help     tooltip text; may be empty
     * @param offered  returns the values that can be chosen where a value is shown; null for none
     * @param text     returns the text of a value
     * @param onChosen receives the chosen value
     */
    ChoiceField(String id, String title, String help, Function<@Nullable V, List<V>> offered, Function<V, String> text,
            Consumer<V> onChosen) {
        this.offered = offered;
        box.setId(id);
        box.setAccessibleText(title);
        box.setMaxWidth(Double.MAX_VALUE);
        box.setConverter(new StringConverter<>() {
            @Override
            public String toString(@Nullable V value) {
                return value == null ? "" : text.apply(value);
            }

            @Override
            public V fromString(String typed) {
                throw new IllegalStateException("values are chosen, not typed");
            }
        });
        box.getItems().setAll(offered.apply(null));
        box.valueProperty().addListener((_, _, now) -> {
            if (!isUpdating && now != null) {
                onChosen.accept(now);
            }
        });
        box.setOnShowing(_ -> set(box.getValue()));
        getChildren().add(box);
        disabledReason = new DisabledReason(this, box, help);
    }

    ComboBox<V> box() {
        return box;
    }

    private void set(@Nullable V value) {
        List<V> values = offered.apply(value);
        isUpdating = true;
        if (!box.getItems().equals(values)) {
            box.getItems().setAll(values);
        }
        box.setValue(value);
        isUpdating = false;
    }

    @Override
    public void show(V value) {
        set(value);
    }

    @Override
    public void showNothing() {
        set(null);
    }

    @Override
    public void setDisabledReason(Optional<String> reason) {
        disabledReason.set(reason);
    }
}
