package lightning.app.property;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javafx.scene.control.MenuButton;
import javafx.scene.layout.StackPane;
import lightning.app.model.EditorModel;
import lightning.app.model.Sentence;
import lightning.app.widget.Obstacle;
import lightning.edit.Change;
import lightning.edit.Command;
import lightning.edit.Situation;
import lightning.jen.PropertyEdit;
import lightning.scene.FromFile;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Scene;

/** What the selected light has from a file: one of those that lie beside the scene. It is read on a thread of its own. */
final class LightFilePart<F extends FromFile> extends StackPane {
    private final EditorModel model;
    private final LightAttribute<Optional<F>> attribute;
    private final MenuButton choice;
    private final Obstacle obstacle;

    /**
     * @param command what choosing one does
     * @param names   those of a folder
     * @param help    what it is
     */
    LightFilePart(EditorModel model, LightAttribute<Optional<F>> attribute, Command command, Function<Path, List<String>> names,
            String help) {
        this.model = model;
        this.attribute = attribute;
        choice = new FileMenu(model, "none", command, names, this::set);
        choice.setId(attribute.name());
        choice.setAccessibleText(attribute.title());
        choice.setMaxWidth(Double.MAX_VALUE);
        getChildren().add(choice);
        obstacle = new Obstacle(this, choice, help);
        model.situationProperty().subscribe(this::show);
    }

    private void show(Situation now) {
        Optional<Light> light = now.selected();
        choice.setText(light.map(attribute::text).orElse("none"));
        obstacle.set(light.isEmpty() ? Optional.of("no light is selected") : attribute.obstacle(light.get().type()));
    }

    /** What was read is taken over by the scene as it is then. */
    private void set(String name) {
        String light = model.selectedLight().name();
        Path folder = FileMenu.folder(model);
        Scene asked = model.scene();
        model.files().beside(() -> attribute.of(PropertyEdit.file(asked, light, attribute, name, folder).light(light).orElseThrow()),
                read -> model.edit(scene -> Change.of(() -> scene.withLight(attribute.with(scene.light(light)
                        .orElseThrow(() -> new IllegalArgumentException("the light is gone")), read)))).ifPresent(model::say),
                e -> model.say(Sentence.of(e)));
    }
}
