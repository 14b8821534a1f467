package lightning.app.property;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.layout.StackPane;
import lightning.app.command.CommandItems;
import lightning.app.model.EditorModel;
import lightning.app.model.Sentence;
import lightning.app.widget.Obstacle;
import lightning.edit.Change;
import lightning.edit.Command;
import lightning.edit.Situation;
import lightning.jen.PropertyEdit;
import lightning.scene.Gobo;
import lightning.scene.Light;
import lightning.scene.LightAttribute;
import lightning.scene.Scene;

/** The picture that the selected light projects: one of those that lie beside the scene. It is read on a thread of its own. */
final class GoboPart extends StackPane {
    private final EditorModel model;
    private final MenuButton choice = new MenuButton("none");
    private final Obstacle obstacle;

    GoboPart(EditorModel model) {
        this.model = model;
        choice.setId("gobo");
        choice.setAccessibleText("gobo");
        choice.setMaxWidth(Double.MAX_VALUE);
        choice.setOnShowing(_ -> fill());
        offer(List.of());
        getChildren().add(choice);
        obstacle = new Obstacle(this, choice, "A picture that the light projects: black holds it back");
        model.situationProperty().subscribe(this::show);
    }

    private void show(Situation now) {
        Optional<Light> light = now.selected();
        choice.setText(light.flatMap(Light::gobo).map(Gobo::file).orElse("none"));
        obstacle.set(light.isEmpty() ? Optional.of("no light is selected") : LightAttribute.GOBO.obstacle(light.get().type()));
    }

    private Path folder() {
        return model.document().file().toAbsolutePath().getParent();
    }

    /** What lies beside the scene is seen a moment later. */
    private void fill() {
        Path folder = folder();
        model.files().beside(() -> PropertyEdit.textures(folder), this::offer, _ -> offer(List.of()));
    }

    private void offer(List<String> names) {
        List<MenuItem> items = new ArrayList<>();
        items.add(item("None", ""));
        items.add(new SeparatorMenuItem());
        names.forEach(name -> items.add(item(name, name)));
        choice.getItems().setAll(items);
    }

    private MenuItem item(String title, String name) {
        return CommandItems.of(model).value(Command.CHOOSE_GOBO, title, () -> set(name));
    }

    /** The picture is taken over by the scene as it is once it was read. */
    private void set(String name) {
        String light = model.selectedLight().name();
        Path folder = folder();
        Scene asked = model.scene();
        model.files().beside(() -> PropertyEdit.gobo(asked, light, name, folder).light(light).orElseThrow().gobo(),
                gobo -> model.edit(scene -> Change.of(() -> scene.withLight(scene.light(light)
                        .orElseThrow(() -> new IllegalArgumentException("the light is gone")).withGobo(gobo)))).ifPresent(model::say),
                e -> model.say(Sentence.of(e)));
    }
}
