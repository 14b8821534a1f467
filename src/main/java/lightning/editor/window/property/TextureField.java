package lightning.editor.window.property;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javafx.css.PseudoClass;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.FileImporter;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.ValueWidget;
import lightning.format.jen.asset.FileKind;
import lightning.scene.asset.TextureMap;

/**
 * Field for a texture: file name, menu of the files next to the scene, also by drop, and the placement on the surface while there is a
 * texture.
 */
final class TextureField extends VBox implements ValueWidget<Optional<TextureMap>> {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private final FileImporter files;
    private final Supplier<Consumer<String>> setter;
    private final TextField file = new TextField();
    private final Label refusal = new Label();
    private final VBox place;
    private final DisabledReason disabledReason;
    private Optional<TextureMap> shown = Optional.empty();

    /**
     * @param placement  widgets of the placement
     * @param setter  returns what receives the file name, empty for none, for a receiver of why it cannot be used
     */
    TextureField(EditorModel model, String id, String title, List<Node> placement,
            Function<Consumer<Optional<String>>, Consumer<String>> setter) {
        files = model.fileImporter();
        this.setter = () -> setter.apply(refused -> refused.ifPresentOrElse(this::showRefusal, this::revert));
        getStyleClass().add("texture-part");
        file.setId(id);
        file.setAccessibleText(Messages.tr("{0}: file name", title));
        file.setPromptText(Messages.tr("{0}: none", title));
        file.setOnAction(_ -> commit());
        file.focusedProperty().addListener((_, was, _) -> {
            if (was) {
                commit();
            }
        });
        file.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE && !file.getText().equals(name())) {
                revert();
                event.consume();
            }
        });
        HBox.setHgrow(file, Priority.ALWAYS);
        var menu = new FileMenu(model, Messages.tr("Choose"), Command.CHOOSE_TEXTURE, FileKind.TEXTURE, this.setter, this::showRefusal);
        menu.setId(id + "-found");
        menu.setAccessibleText(Messages.tr("Choose an image: {0}", title));
        menu.setMinWidth(USE_PREF_SIZE);
        refusal.setId(id + "-refusal");
        refusal.getStyleClass().add("refusal");
        refusal.setWrapText(true);
        refusal.managedProperty().bind(refusal.visibleProperty());
        refusal.visibleProperty().bind(refusal.textProperty().isNotEmpty());
        var row = new HBox(file, menu);
        row.getStyleClass().add("header-row");
        disabledReason = new DisabledReason(this, row);
        place = new VBox(placement.toArray(Node[]::new));
        place.getStyleClass().add("texture-part");
        place.managedProperty().bind(place.visibleProperty());
        getChildren().addAll(row, refusal, place);
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
    }

    @Override
    public void show(Optional<TextureMap> texture) {
        boolean isOther = !texture.map(TextureMap::file).equals(shown.map(TextureMap::file));
        shown = texture;
        if (isOther) {
            revert();
        }
        place.setVisible(texture.isPresent());
    }

    @Override
    public void showNothing() {
        show(Optional.empty());
        revert();
    }

    @Override
    public void setDisabledReason(Optional<String> reason) {
        disabledReason.set(reason);
    }

    private String name() {
        return shown.map(TextureMap::file).orElse("");
    }

    @Override
    public void revert() {
        file.setText(name());
        showRefusal("");
    }

    private void showRefusal(String reason) {
        refusal.setText(reason);
        file.setAccessibleHelp(reason);
        file.pseudoClassStateChanged(REFUSED, !reason.isEmpty());
    }

    private void commit() {
        String typed = file.getText().strip();
        if (typed.equals(name())) {
            revert();
        } else {
            setter.get().accept(typed);
        }
    }

    /** Returns the first image among dropped files; none while the field is disabled. */
    private Optional<Path> image(List<File> dropped) {
        return file.isDisabled() ? Optional.empty() : dropped.stream().map(File::toPath).filter(FileKind.TEXTURE::isNamed).findFirst();
    }

    /** Uses the first image among dropped files. Returns whether there is one. */
    boolean drop(List<File> dropped) {
        Optional<Path> image = image(dropped);
        image.ifPresent(path -> files.importFile(FileKind.TEXTURE, path, setter.get(), this::showRefusal));
        return image.isPresent();
    }
}
