package lightning.app.property;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.app.command.CommandItems;
import lightning.app.model.EditorModel;
import lightning.app.model.Sentence;
import lightning.app.widget.ArrowWidget;
import lightning.app.widget.Gauge;
import lightning.app.widget.Obstacle;
import lightning.edit.Change;
import lightning.edit.Command;
import lightning.edit.MaterialEdits;
import lightning.edit.Steps;
import lightning.jen.PropertyEdit;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.TextureMap;

/**
 * The picture on a material: typed as the scene file names it, or taken from those that lie beside the scene, and how
 * often it repeats. It is read on a thread of its own.
 */
final class TexturePart extends VBox {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");
    private static final Optional<String> NO_TEXTURE = Optional.of("the material has no texture");

    private final EditorModel model;
    private final TextField file = new TextField();
    private final MenuButton found = new MenuButton("Choose");
    private final Label refusal = new Label();
    private final ArrowWidget repeatU;
    private final ArrowWidget repeatV;
    private final Obstacle obstacle;
    private Material shown;

    TexturePart(EditorModel model) {
        this.model = model;
        getStyleClass().add("texture-part");
        file.setId("texture");
        file.setAccessibleText("texture's file name");
        file.setPromptText("none");
        file.setOnAction(_ -> commit());
        file.focusedProperty().addListener((_, was, _) -> {
            if (was) {
                commit();
            }
        });
        file.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE && !file.getText().equals(name(shown))) {
                revert();
                event.consume();
            }
        });
        HBox.setHgrow(file, Priority.ALWAYS);
        found.setId("textures");
        found.setAccessibleText("Choose a texture");
        found.setMinWidth(USE_PREF_SIZE);
        found.setOnShowing(_ -> fill());
        offer(List.of());
        refusal.setId("texture-refusal");
        refusal.getStyleClass().add("refusal");
        refusal.setWrapText(true);
        refusal.managedProperty().bind(refusal.visibleProperty());
        refusal.visibleProperty().bind(refusal.textProperty().isNotEmpty());
        var row = new HBox(file, found);
        row.getStyleClass().add("header-row");
        obstacle = new Obstacle(this, row);
        repeatU = repeat("repeat-u", "Repeat around", "repeat u", (map, v) -> new TextureMap(map.file(), v, map.repeatV(), map.image()));
        repeatV = repeat("repeat-v", "Repeat along", "repeat v", (map, v) -> new TextureMap(map.file(), map.repeatU(), v, map.image()));
        getChildren().addAll(row, refusal, repeatU, repeatV);
    }

    private interface Repeat {
        TextureMap of(TextureMap map, double v);
    }

    private ArrowWidget repeat(String id, String label, String title, Repeat with) {
        var widget = new ArrowWidget(label, title, Gauge.of(title, new Steps(1, -Limits.MAX_REPEAT, Limits.MAX_REPEAT),
                (v, gesture) -> model.edit(scene -> MaterialEdits.with(scene, shown.name(),
                        m -> m.withTexture(m.texture().map(map -> with.of(map, v)))), gesture)));
        widget.setId(id);
        return widget;
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
        found.getItems().setAll(items);
    }

    private MenuItem item(String title, String name) {
        return CommandItems.of(model).value(Command.CHOOSE_TEXTURE, title, () -> set(name));
    }

    void show(Material material) {
        boolean other = shown == null || !shown.name().equals(material.name()) || !name(shown).equals(name(material));
        shown = material;
        if (other) {
            revert();
        }
        Optional<String> none = material.texture().isEmpty() ? NO_TEXTURE : Optional.empty();
        repeatU.setObstacle(none);
        repeatV.setObstacle(none);
        repeatU.show(material.texture().map(TextureMap::repeatU).orElse(1.0));
        repeatV.show(material.texture().map(TextureMap::repeatV).orElse(1.0));
    }

    /** Shows that there is no material. */
    void showNothing() {
        shown = null;
        revert();
        repeatU.showNothing();
        repeatV.showNothing();
    }

    void setObstacle(Optional<String> reason) {
        obstacle.set(reason);
        if (reason.isPresent()) {
            repeatU.setObstacle(reason);
            repeatV.setObstacle(reason);
        }
    }

    private static String name(Material material) {
        return material == null ? "" : material.texture().map(TextureMap::file).orElse("");
    }

    private void revert() {
        file.setText(name(shown));
        mark("");
    }

    private void mark(String reason) {
        refusal.setText(reason);
        file.setAccessibleHelp(reason);
        file.pseudoClassStateChanged(REFUSED, !reason.isEmpty());
    }

    private void commit() {
        String typed = file.getText().strip();
        if (typed.equals(name(shown))) {
            revert();
        } else {
            set(typed);
        }
    }

    private void set(String wanted) {
        String material = shown.name();
        if (wanted.isEmpty()) {
            model.edit(scene -> MaterialEdits.noTexture(scene, material)).ifPresent(this::mark);
            return;
        }
        var scene = model.scene();
        Path folder = folder();
        model.files().beside(() -> MaterialEdits.texture(scene, material, wanted, folder), read -> take(material, read),
                why -> mark(Sentence.of(why)));
    }

    private void take(String material, Change read) {
        switch (read) {
            case Change.Refused refused -> mark(refused.reason());
            case Change.To to -> model.edit(scene -> MaterialEdits.with(scene, material,
                    m -> m.withTexture(to.scene().materialsByName().get(material).texture()))).ifPresentOrElse(this::mark, this::revert);
        }
    }
}
