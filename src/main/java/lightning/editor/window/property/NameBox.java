package lightning.editor.window.property;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.ComboBox;
import javafx.scene.layout.StackPane;
import javafx.util.StringConverter;
import lightning.base.text.Texts;
import lightning.editor.document.LightEdits;
import lightning.editor.document.Situation;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.Obstacle;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.ValueKind;

/** A box of the names that an attribute of the selected light can have, and none. */
final class NameBox extends StackPane {
    private final LightAttribute<String> attribute;
    private final ValueKind.Naming kind;
    private final ComboBox<String> box = new ComboBox<>();
    private final Obstacle obstacle;
    private boolean showing;

    /** @param seen as in {@link PropertyPane} */
    NameBox(SceneEditor editor, LightAttribute<String> attribute, ValueKind.Naming kind, ObservableValue<Situation> seen) {
        this.attribute = attribute;
        this.kind = kind;
        box.setId("light-" + attribute.name());
        box.setAccessibleText(Texts.of(attribute.title()));
        box.setMaxWidth(Double.MAX_VALUE);
        box.setConverter(new StringConverter<>() {
            @Override
            public String toString(String name) {
                return name == null ? "" : name.isEmpty() ? Texts.of("none") : name;
            }

            @Override
            public String fromString(String text) {
                throw new IllegalStateException("the names are chosen, not typed");
            }
        });
        box.valueProperty().addListener((_, _, now) -> {
            if (!showing && now != null) {
                String name = editor.selection().lightName();
                editor.editOrReport(scene -> LightEdits.with(scene, name, light -> attribute.with(light, now)));
            }
        });
        getChildren().add(box);
        obstacle = new Obstacle(this, box, Texts.of(kind.help()));
        seen.subscribe(this::show);
    }

    private void show(Situation now) {
        Optional<Light> light = now.selected();
        showing = true;
        List<String> names = Stream.concat(Stream.of(""), kind.names().apply(now.scene()).stream()).toList();
        if (!box.getItems().equals(names)) {
            box.getItems().setAll(names);
        }
        box.setValue(light.map(attribute::of).orElse(null));
        showing = false;
        obstacle.set(light.isPresent() ? attribute.obstacle(light.get().type()) : Optional.of(Texts.of("no light is selected")));
    }
}
