package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javafx.scene.control.ComboBox;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.editor.window.widget.DisabledReason;
import lightning.scene.attribute.ChoiceKind;
import lightning.scene.attribute.SceneAttribute;
import org.jspecify.annotations.Nullable;

/** Combo box for an attribute with a fixed set of values. */
final class AttributeChoiceBox<V> extends StackPane {
    private final ComboBox<String> box = new ComboBox<>();
    private final ChoiceKind<V> choice;
    private final DisabledReason disabledReason;
    private boolean isUpdating;

    /**
     * @param help  tooltip text; may be empty
     * @param onChosen  receives the chosen value
     */
    AttributeChoiceBox(SceneAttribute<?, V> attribute, ChoiceKind<V> choice, String help, Consumer<V> onChosen) {
        this(attribute.id(), Messages.tr(attribute.title()), choice, help, onChosen);
    }

    /**
     * @param id  of the box
     * @param title  for screen readers
     * @param help  tooltip text; may be empty
     * @param onChosen  receives the chosen value
     */
    AttributeChoiceBox(String id, String title, ChoiceKind<V> choice, String help, Consumer<V> onChosen) {
        this.choice = choice;
        box.setId(id);
        box.setAccessibleText(title);
        box.setMaxWidth(Double.MAX_VALUE);
        choice.labels().forEach(label -> box.getItems().add(SectionLayout.title(label)));
        getChildren().add(box);
        disabledReason = new DisabledReason(this, box, help);
        box.valueProperty().addListener((_, _, now) -> {
            if (!isUpdating && now != null) {
                onChosen.accept(value(now));
            }
        });
    }

    /** Returns the value of a displayed title. */
    private V value(String title) {
        return choice.values().stream().filter(v -> SectionLayout.title(choice.label(v)).equals(title)).findFirst().orElseThrow();
    }

    ComboBox<String> box() {
        return box;
    }

    /** Shows a value, and offers only those that pass a test. */
    void show(V value, Predicate<V> isOffered) {
        List<String> offered = choice.values().stream().filter(v -> v.equals(value) || isOffered.test(v))
                .map(v -> SectionLayout.title(choice.label(v))).toList();
        if (!offered.equals(box.getItems())) {
            isUpdating = true;
            box.getItems().setAll(offered);
            isUpdating = false;
        }
        show(value);
    }

    void show(V value) {
        setWord(SectionLayout.title(choice.label(value)));
    }

    void showNothing() {
        setWord(null);
    }

    private void setWord(@Nullable String word) {
        isUpdating = true;
        box.setValue(word);
        isUpdating = false;
    }

    /** Disables the box with a reason, as a clause, or enables it. */
    void setDisabledReason(Optional<String> reason) {
        disabledReason.set(reason);
    }
}
