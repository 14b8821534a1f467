package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.ValueWidget;
import lightning.scene.asset.FileAsset;

/** Field for a file asset, chosen from the files next to the scene. */
final class FileField<F extends FileAsset> extends StackPane implements ValueWidget<Optional<F>> {
    private final FileMenu menu;
    private final DisabledReason disabledReason;

    /**
     * @param title  for screen readers
     * @param setter  as in {@link FileMenu}
     */
    FileField(EditorModel model, String id, String title, FileChoice choice, Supplier<Consumer<String>> setter) {
        menu = new FileMenu(model, Messages.tr("none"), choice.command(), choice.kind(), setter, model.editor().message()::show);
        menu.setId(id);
        menu.setAccessibleText(title);
        menu.setMaxWidth(Double.MAX_VALUE);
        getChildren().add(menu);
        disabledReason = new DisabledReason(this, menu, choice.help());
    }

    @Override
    public void show(Optional<F> asset) {
        menu.setText(asset.map(FileAsset::file).orElse(Messages.tr("none")));
    }

    @Override
    public void showNothing() {
        show(Optional.empty());
    }

    @Override
    public void setDisabledReason(Optional<String> reason) {
        disabledReason.set(reason);
    }
}
