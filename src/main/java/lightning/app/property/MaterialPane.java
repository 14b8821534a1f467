package lightning.app.property;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.app.command.CommandButton;
import lightning.app.model.EditorModel;
import lightning.app.model.MaterialChoice;
import lightning.app.widget.ArrowWidget;
import lightning.app.widget.ColorSliders;
import lightning.app.widget.Gauge;
import lightning.app.widget.Obstacle;
import lightning.edit.Command;
import lightning.edit.MaterialEdits;
import lightning.edit.Steps;
import lightning.scene.Limits;
import lightning.scene.Material;

/** The property editor of a material: its colours, its shininess, its texture. All shapes that have it change together. */
final class MaterialPane extends VBox {
    private static final Optional<String> NO_MATERIAL = Optional.of("the scene has no shapes");
    private static final int NAMES_SHOWN = 4;

    private final EditorModel model;
    private final ComboBox<String> name = new ComboBox<>();
    private final Label users = new Label();
    private final Map<SurfaceColor, ColorSliders> colors = new EnumMap<>(SurfaceColor.class);
    private final ArrowWidget shininess;
    private final TexturePart texture;
    private final Obstacle unnamed;
    private String shown = "";
    private boolean showing;

    MaterialPane(EditorModel model) {
        this.model = model;
        setId("material");
        getStyleClass().add("properties");
        for (SurfaceColor color : SurfaceColor.values()) {
            colors.put(color, color.sliders(model));
        }
        shininess = new ArrowWidget("Shininess", "shininess", Gauge.of("shininess", new Steps(1, 0, Limits.MAX_SHININESS),
                (v, gesture) -> model.edit(scene -> MaterialEdits.shininess(scene, shown, v), gesture)));
        shininess.setId("shininess");
        texture = new TexturePart(model);
        name.setId("material-name");
        name.setAccessibleText("material");
        name.setMaxWidth(Double.MAX_VALUE);
        var named = new StackPane(name);
        unnamed = new Obstacle(named, name, "The material that is edited, with all shapes that have it");
        HBox.setHgrow(named, Priority.ALWAYS);
        var row = new HBox(named, new CommandButton(model, Command.PICK_MATERIAL, false));
        row.getStyleClass().add("header-row");
        users.setId("material-users");
        users.getStyleClass().add("caption");
        users.setWrapText(true);
        var header = new VBox(row, users);
        header.getStyleClass().add("light-header");
        ScrollPane scroll = Sections.scroll(header,
                Sections.section("Diffuse", colors.get(SurfaceColor.DIFFUSE)),
                Sections.section("Texture", texture),
                Sections.section("Specular", colors.get(SurfaceColor.SPECULAR), shininess),
                Sections.section("Reflective", colors.get(SurfaceColor.REFLECTIVE)),
                Sections.section("Ambient", colors.get(SurfaceColor.AMBIENT)));
        setVgrow(scroll, Priority.ALWAYS);
        getChildren().add(scroll);
        name.valueProperty().addListener((_, _, now) -> {
            if (!showing && now != null) {
                model.materials().choose(now);
            }
        });
        model.materials().materialProperty().subscribe(this::show);
        model.sceneProperty().subscribe((before, now) -> {
            if (!MaterialChoice.haveSameMaterials(before, now)) {
                show(model.materials().material());
            }
        });
    }

    private void show(Material material) {
        Optional<String> obstacle = material == null ? NO_MATERIAL : Optional.empty();
        colors.values().forEach(c -> c.setObstacle(obstacle));
        shininess.setObstacle(obstacle);
        texture.setObstacle(obstacle);
        unnamed.set(obstacle);
        if (material == null) {
            showNothing();
            return;
        }
        if (!material.name().equals(shown)) {
            // What was typed was meant for the other material.
            colors.values().forEach(ColorSliders::revert);
            shininess.revert();
        }
        shown = material.name();
        showNames();
        colors.forEach((color, sliders) -> sliders.show(color.of(material)));
        shininess.show(material.shininess());
        texture.show(material);
    }

    private void showNothing() {
        shown = "";
        users.setText("");
        showing = true;
        name.setValue(null);
        showing = false;
        colors.values().forEach(ColorSliders::showNothing);
        shininess.showNothing();
        texture.showNothing();
    }

    private void showNames() {
        showing = true;
        List<String> names = MaterialChoice.names(model.scene());
        if (!name.getItems().equals(names)) {
            name.getItems().setAll(names);
        }
        name.setValue(shown);
        showing = false;
        List<String> shapes = MaterialChoice.shapesOf(model.scene(), shown);
        users.setText(
                shapes.isEmpty() ? "No shape has it" : "On " + String.join(", ", shapes.subList(0, Math.min(NAMES_SHOWN, shapes.size())))
                        + (shapes.size() > NAMES_SHOWN ? " and " + (shapes.size() - NAMES_SHOWN) + " more" : ""));
    }
}
