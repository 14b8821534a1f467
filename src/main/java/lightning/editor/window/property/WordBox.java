package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.Consumer;
import javafx.scene.control.ComboBox;
import javafx.scene.layout.StackPane;
import lightning.base.text.Texts;
import lightning.editor.window.widget.Obstacle;
import lightning.scene.Attribute;
import lightning.scene.Choice;

/** A box of the words of an attribute that is a choice. */
final class WordBox<V> extends StackPane {
    private final ComboBox<String> box = new ComboBox<>();
    private final Choice<V> choice;
    private final Obstacle obstacle;
    private boolean showing;

    /**
     * @param help what the tooltip says; may be empty
     * @param set  gets what the artist chooses
     */
    WordBox(Attribute<?, V> attribute, Choice<V> choice, String help, Consumer<V> set) {
        this.choice = choice;
        box.setId(attribute.title());
        box.setAccessibleText(Texts.of(attribute.title()));
        box.setMaxWidth(Double.MAX_VALUE);
        choice.words().forEach(word -> box.getItems().add(Sections.title(word)));
        getChildren().add(box);
        obstacle = new Obstacle(this, box, help);
        box.valueProperty().addListener((_, _, now) -> {
            if (!showing && now != null) {
                set.accept(value(now));
            }
        });
    }

    /** The value of the word that is shown so. */
    private V value(String shown) {
        return choice.value(choice.words().stream().filter(w -> Sections.title(w).equals(shown)).findFirst().orElseThrow());
    }

    ComboBox<String> box() {
        return box;
    }

    void show(V value) {
        choose(Sections.title(choice.text(value)));
    }

    void showNothing() {
        choose(null);
    }

    private void choose(String word) {
        showing = true;
        box.setValue(word);
        showing = false;
    }

    /** Disables it with a reason, a clause; or enables it. */
    void setObstacle(Optional<String> reason) {
        obstacle.set(reason);
    }
}
