package lightning.editor.window.property;

import static java.util.Objects.requireNonNull;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import javafx.css.PseudoClass;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.EditOutcome;
import lightning.editor.document.MaterialEdits;
import lightning.editor.document.StepRange;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.model.FileImporter;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.NumberSetting;
import lightning.format.jen.asset.FileKind;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap;
import lightning.scene.attribute.ValueKind;
import lightning.scene.material.Material;
import lightning.scene.material.MaterialAttribute;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Field for a texture of a material: file name, menu of the files next to the scene, also by drop, place on the surface, and what follows the edges. Reads files in the background. */
final class TextureField extends VBox {
    private static final StepRange OFFSETS = new StepRange(0.1, -SceneLimits.MAX_REPEAT, SceneLimits.MAX_REPEAT);
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private final SceneEditor editor;
    private final FileImporter files;
    private final MaterialAttribute<Optional<TextureMap>> attribute;
    private final Optional<String> missingReason;
    private final TextField file = new TextField();
    private final FileMenu fileMenu;
    private final Label refusal = new Label();
    /** Place on the surface, shown with a texture. */
    private final VBox place = new VBox();
    private final List<NumberWidget> numbers;
    private final AttributeChoiceBox<TextureWrap> wrap;
    private final DisabledReason disabledReason;
    private @Nullable Material shownMaterial;

    TextureField(SceneEditor editor, CommandRegistry commands, FileImporter files, MaterialAttribute<Optional<TextureMap>> attribute) {
        this.editor = editor;
        this.files = files;
        this.attribute = attribute;
        String title = attribute.title();
        missingReason = Optional.of(Messages.tr("the material has no {0}", title));
        getStyleClass().add("texture-part");
        file.setId(attribute.id());
        file.setAccessibleText(Messages.tr("{0}: file name", title));
        file.setPromptText(Messages.tr("{0}: none", title));
        file.setOnAction(_ -> commit());
        file.focusedProperty().addListener((_, was, _) -> {
            if (was) {
                commit();
            }
        });
        file.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE && !file.getText().equals(name(shownMaterial))) {
                revert();
                event.consume();
            }
        });
        HBox.setHgrow(file, Priority.ALWAYS);
        fileMenu = new FileMenu(commands, files, Messages.tr("Choose"), Command.CHOOSE_TEXTURE, FileKind.TEXTURE, this::set, this::browse);
        fileMenu.setId(attribute.id() + "-found");
        fileMenu.setAccessibleText(Messages.tr("Choose an image: {0}", title));
        fileMenu.setMinWidth(USE_PREF_SIZE);
        refusal.setId(attribute.id() + "-refusal");
        refusal.getStyleClass().add("refusal");
        refusal.setWrapText(true);
        refusal.managedProperty().bind(refusal.visibleProperty());
        refusal.visibleProperty().bind(refusal.textProperty().isNotEmpty());
        var row = new HBox(file, fileMenu);
        row.getStyleClass().add("header-row");
        disabledReason = new DisabledReason(this, row);
        numbers = List.of(
                number("repeat-u", repeatName() + " u", Messages.tr("Repeat U"),
                        new StepRange(1, -SceneLimits.MAX_REPEAT, SceneLimits.MAX_REPEAT),
                        TextureMap::repeatU, TextureMap::withRepeatU),
                number("repeat-v", repeatName() + " v", Messages.tr("Repeat V"),
                        new StepRange(1, -SceneLimits.MAX_REPEAT, SceneLimits.MAX_REPEAT),
                        TextureMap::repeatV, TextureMap::withRepeatV),
                number("offset-u", name("offset") + " u", Messages.tr("Offset U"), OFFSETS, map -> map.placement().offsetU(),
                        (map, v) -> map.withPlacement(map.placement().withOffsetU(v))),
                number("offset-v", name("offset") + " v", Messages.tr("Offset V"), OFFSETS, map -> map.placement().offsetV(),
                        (map, v) -> map.withPlacement(map.placement().withOffsetV(v))),
                number("rotation", name("rotation"), Messages.tr("Rotation"),
                        new StepRange(5, -TexturePlacement.MAX_ROTATION, TexturePlacement.MAX_ROTATION), map -> map.placement().rotation(),
                        (map, v) -> map.withPlacement(map.placement().withRotation(v))));
        wrap = new AttributeChoiceBox<>(wrapName().replace('_', '-'), Messages.tr("{0}: beyond its edges", title),
                ValueKind.TextureKind.WRAP,
                Messages.tr("What a surface shows beyond the edges of an image; the first word is for left and right"),
                v -> editor.edit(scene -> MaterialEdits.edit(scene, editedMaterial().name(),
                        m -> attribute.with(m, attribute.get(m).map(map -> map.withWrap(v)))), null));
        getChildren().addAll(row, refusal);
        setOnDragOver(e -> {
            if (image(e.getDragboard().getFiles()).isPresent()) {
                e.acceptTransferModes(TransferMode.COPY);
                e.consume();
            }
        });
        setOnDragDropped(e -> {
            if (drop(e.getDragboard().getFiles())) {
                e.setDropCompleted(true);
                e.consume();
            }
        });
        numbers.forEach(number -> place.getChildren().add(number.widget));
        place.getChildren().add(MaterialPane.labeled(Messages.tr("Wrap"), wrap));
        place.getStyleClass().add("texture-part");
        place.managedProperty().bind(place.visibleProperty());
        getChildren().add(place);
    }

    /** Returns the name of the repeat property in the scene file. */
    private String repeatName() {
        return attribute.kind() instanceof ValueKind.TextureKind t ? t.repeatName() : "repeat";
    }

    /** Returns the name of another property of the placement in the scene file. */
    private String name(String property) {
        return repeatName().replace("repeat", property);
    }

    private String wrapName() {
        return name("wrap");
    }

    /** A number of the texture, and how a texture without it shows. */
    private record NumberWidget(ArrowWidget widget, ToDoubleFunction<TextureMap> value, double initial) {}

    private interface NumberEdit {
        TextureMap apply(TextureMap map, double v);
    }

    private NumberWidget number(String id, String title, String label, StepRange range, ToDoubleFunction<TextureMap> value,
            NumberEdit edit) {
        var widget = new ArrowWidget(label, title, NumberSetting.of(title, range,
                (v, gesture) -> editor.edit(scene -> MaterialEdits.edit(scene, editedMaterial().name(),
                        m -> attribute.with(m, attribute.get(m).map(map -> edit.apply(map, v)))), gesture)));
        boolean isRepeat = id.startsWith("repeat");
        widget.setId(isRepeat ? title.replace('_', '-').replace(' ', '-') : attribute.id() + "-" + id);
        return new NumberWidget(widget, value, isRepeat ? 1 : 0);
    }

    void show(Material material) {
        boolean isOther =
                shownMaterial == null || !shownMaterial.name().equals(material.name()) || !name(shownMaterial).equals(name(material));
        shownMaterial = material;
        if (isOther) {
            revert();
        }
        Optional<String> reason = attribute.get(material).isEmpty() ? missingReason : Optional.empty();
        place.setVisible(reason.isEmpty());
        numbers.forEach(number -> {
            number.widget.setDisabledReason(reason);
            number.widget.show(attribute.get(material).map(number.value::applyAsDouble).orElse(number.initial));
        });
        wrap.setDisabledReason(reason);
        wrap.show(attribute.get(material).map(TextureMap::wrap).orElse(TextureWrap.REPEAT));
    }

    /** Clears the field. */
    void showNothing() {
        shownMaterial = null;
        revert();
        place.setVisible(false);
        numbers.forEach(number -> number.widget.showNothing());
        wrap.showNothing();
    }

    void setDisabledReason(Optional<String> reason) {
        disabledReason.set(reason);
        if (reason.isPresent()) {
            numbers.forEach(number -> number.widget.setDisabledReason(reason));
            wrap.setDisabledReason(reason);
        }
    }

    private String name(@Nullable Material material) {
        return material == null ? "" : attribute.get(material).map(TextureMap::file).orElse("");
    }

    private void revert() {
        file.setText(name(shownMaterial));
        showRefusal("");
    }

    private void showRefusal(String reason) {
        refusal.setText(reason);
        file.setAccessibleHelp(reason);
        file.pseudoClassStateChanged(REFUSED, !reason.isEmpty());
    }

    private void commit() {
        String typed = file.getText().strip();
        if (typed.equals(name(shownMaterial))) {
            revert();
        } else {
            set(typed);
        }
    }

    private void set(String fileName) {
        String material = editedMaterial().name();
        if (fileName.isEmpty()) {
            editor.edit(scene -> MaterialEdits.set(scene, material, attribute, Optional.empty())).ifPresent(this::showRefusal);
            return;
        }
        var scene = editor.scene();
        Path folder = files.folder();
        files.files().runConcurrently(() -> MaterialEdits.setTexture(scene, material, attribute, fileName, folder),
                loaded -> applyLoaded(material, loaded),
                failure -> showRefusal(ErrorMessage.of(failure)));
    }

    private void browse() {
        files.promptAndImport(Command.CHOOSE_TEXTURE.plainTitle(), FileKind.TEXTURE, setForThisMaterial(), this::showRefusal);
    }

    /** Returns an action that sets the file, unless another material is shown by then. */
    private Consumer<String> setForThisMaterial() {
        String material = editedMaterial().name();
        return name -> {
            if (editedMaterial().name().equals(material)) {
                set(name);
            }
        };
    }

    /** Returns the first image among dropped files; none without a material. */
    private Optional<Path> image(List<File> dropped) {
        return shownMaterial == null ? Optional.empty() : dropped.stream().map(File::toPath).filter(FileKind.TEXTURE::isNamed).findFirst();
    }

    /** Uses the first image among dropped files. Returns whether there is one. */
    boolean drop(List<File> dropped) {
        Optional<Path> image = image(dropped);
        image.ifPresent(file -> files.importFile(FileKind.TEXTURE, file, setForThisMaterial(), this::showRefusal));
        return image.isPresent();
    }

    private void applyLoaded(String material, EditOutcome loaded) {
        switch (loaded) {
            case EditOutcome.Refused refused -> showRefusal(refused.reason());
            case EditOutcome.Applied to -> editor.edit(scene -> MaterialEdits.edit(scene, material,
                    m -> attribute.copy(to.scene().materialsByName().get(material), m))).ifPresentOrElse(this::showRefusal, this::revert);
        }
    }

    /** Returns the material of the field, which is hidden without one. */
    private Material editedMaterial() {
        return requireNonNull(shownMaterial);
    }
}
