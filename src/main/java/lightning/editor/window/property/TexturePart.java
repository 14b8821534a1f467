package lightning.editor.window.property;

import java.nio.file.Path;
import java.util.Optional;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.document.MaterialEdits;
import lightning.editor.document.Steps;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.FileBringer;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.Gauge;
import lightning.editor.window.widget.Obstacle;
import lightning.format.jen.FileKind;
import lightning.scene.Limits;
import lightning.scene.Material;
import lightning.scene.MaterialAttribute;
import lightning.scene.TextureMap;
import lightning.scene.ValueKind;

/**
 * A picture that a material has: typed as the scene file names it, or taken from those that lie beside the scene, and how
 * often it repeats. It is read on a thread of its own.
 */
final class TexturePart extends VBox {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private final SceneEditor editor;
    private final FileBringer files;
    private final MaterialAttribute<Optional<TextureMap>> attribute;
    private final Optional<String> missing;
    private final TextField file = new TextField();
    private final FileMenu found;
    private final Label refusal = new Label();
    private final ArrowWidget repeatU;
    private final ArrowWidget repeatV;
    private final Obstacle obstacle;
    private Material shown;

    TexturePart(SceneEditor editor, Commands commands, FileBringer files, MaterialAttribute<Optional<TextureMap>> attribute) {
        this.editor = editor;
        this.files = files;
        this.attribute = attribute;
        String title = attribute.title();
        missing = Optional.of(Texts.of("the material has no {0}", title));
        getStyleClass().add("texture-part");
        file.setId(title);
        file.setAccessibleText(Texts.of("{0}: file name", title));
        file.setPromptText(Texts.of("none"));
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
        found = new FileMenu(commands, files, Texts.of("Choose"), Command.CHOOSE_TEXTURE, FileKind.TEXTURE, this::set, this::browse);
        found.setId(title + "-found");
        found.setAccessibleText(Texts.of("Choose a picture: {0}", title));
        found.setMinWidth(USE_PREF_SIZE);
        refusal.setId(title + "-refusal");
        refusal.getStyleClass().add("refusal");
        refusal.setWrapText(true);
        refusal.managedProperty().bind(refusal.visibleProperty());
        refusal.visibleProperty().bind(refusal.textProperty().isNotEmpty());
        var row = new HBox(file, found);
        row.getStyleClass().add("header-row");
        obstacle = new Obstacle(this, row);
        repeatU = repeat(id("u"), Texts.of("Repeat around"), repeats("u"),
                (map, v) -> new TextureMap(map.file(), v, map.repeatV(), map.image()));
        repeatV = repeat(id("v"), Texts.of("Repeat along"), repeats("v"),
                (map, v) -> new TextureMap(map.file(), map.repeatU(), v, map.image()));
        getChildren().addAll(row, refusal, repeatU, repeatV);
    }

    private String id(String axis) {
        return repeats(axis).replace('_', '-').replace(' ', '-');
    }

    /** As the scene file calls it. */
    private String repeats(String axis) {
        return (attribute.kind() instanceof ValueKind.Texturing t ? t.repeat() : "repeat") + " " + axis;
    }

    private interface Repeat {
        TextureMap of(TextureMap map, double v);
    }

    private ArrowWidget repeat(String id, String label, String title, Repeat with) {
        var widget = new ArrowWidget(label, title, Gauge.of(title, new Steps(1, -Limits.MAX_REPEAT, Limits.MAX_REPEAT),
                (v, gesture) -> editor.edit(scene -> MaterialEdits.with(scene, shown.name(),
                        m -> attribute.with(m, attribute.of(m).map(map -> with.of(map, v)))), gesture)));
        widget.setId(id);
        return widget;
    }

    void show(Material material) {
        boolean other = shown == null || !shown.name().equals(material.name()) || !name(shown).equals(name(material));
        shown = material;
        if (other) {
            revert();
        }
        Optional<String> none = attribute.of(material).isEmpty() ? missing : Optional.empty();
        repeatU.setObstacle(none);
        repeatV.setObstacle(none);
        repeatU.show(attribute.of(material).map(TextureMap::repeatU).orElse(1.0));
        repeatV.show(attribute.of(material).map(TextureMap::repeatV).orElse(1.0));
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

    private String name(Material material) {
        return material == null ? "" : attribute.of(material).map(TextureMap::file).orElse("");
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
            editor.edit(scene -> MaterialEdits.set(scene, material, attribute, Optional.empty())).ifPresent(this::mark);
            return;
        }
        var scene = editor.scene();
        Path folder = files.folder();
        files.files().beside(() -> MaterialEdits.picture(scene, material, attribute, wanted, folder), read -> take(material, read),
                why -> mark(Sentence.of(why)));
    }

    private void browse() {
        String material = shown.name();
        files.browse(Command.CHOOSE_TEXTURE.plainTitle(), FileKind.TEXTURE, name -> {
            if (shown.name().equals(material)) {
                set(name);
            }
        }, this::mark);
    }

    private void take(String material, Change read) {
        switch (read) {
            case Change.Refused refused -> mark(refused.reason());
            case Change.To to -> editor.edit(scene -> MaterialEdits.with(scene, material,
                    m -> attribute.copy(to.scene().materialsByName().get(material), m))).ifPresentOrElse(this::mark, this::revert);
        }
    }
}
