package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.Function;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Button;
import javafx.scene.control.TextField;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.document.CameraEdits;
import lightning.document.EditOutcome;
import lightning.editor.EditorState;
import lightning.editor.window.model.SceneEditor;
import lightning.scene.Scene;

/** Choice among the scene's named cameras, and a field that saves the picture's camera under a name. */
final class NamedCameraField extends VBox {
    private final SceneEditor editor;
    private final ChoiceField<String> list;
    private final HBox chosen;
    private final TextField name = new TextField();

    NamedCameraField(SceneEditor editor, ObservableValue<EditorState> visibleState) {
        this.editor = editor;
        getStyleClass().add("section-rows");
        list = new ChoiceField<>("cameras", Messages.tr("Named cameras"), Messages.tr("View the picture from a named camera of the scene"),
                _ -> editor.scene().cameraNames(), camera -> camera, camera -> edit(scene -> CameraEdits.choose(scene, camera)));
        list.box().setPromptText(Messages.tr("Choose a camera"));
        HBox.setHgrow(list, Priority.ALWAYS);
        var delete = new Button(Messages.tr("Delete"));
        delete.setId("delete-camera");
        delete.setMinWidth(Region.USE_PREF_SIZE);
        delete.setTooltip(new Tooltip(Messages.tr("Delete the chosen camera; the picture stays")));
        delete.setOnAction(
                _ -> Optional.ofNullable(list.box().getValue()).ifPresent(camera -> edit(scene -> CameraEdits.delete(scene, camera))));
        chosen = new HBox(list, delete);
        chosen.getStyleClass().add("header-row");
        name.setId("camera-name");
        name.setPromptText(Messages.tr("Camera name"));
        name.setAccessibleText(Messages.tr("Camera name"));
        HBox.setHgrow(name, Priority.ALWAYS);
        var save = new Button(Messages.tr("Save Camera"));
        save.setId("save-camera");
        save.setMinWidth(Region.USE_PREF_SIZE);
        save.setTooltip(new Tooltip(Messages.tr("Save the picture's camera in the scene under this name")));
        save.setOnAction(_ -> save());
        name.setOnAction(_ -> save());
        var saved = new HBox(name, save);
        saved.getStyleClass().add("header-row");
        getChildren().setAll(chosen, saved);
        visibleState.subscribe(_ -> show());
    }

    private void edit(Function<Scene, EditOutcome> edit) {
        editor.editAndRenderOrReport(edit, null);
    }

    private void save() {
        String typed = name.getText().strip();
        String saved = typed.isEmpty() ? CameraEdits.freeName(editor.scene()) : typed;
        if (editor.editOrReport(scene -> CameraEdits.keep(scene, saved)).isEmpty()) {
            name.clear();
        }
    }

    private void show() {
        Scene scene = editor.scene();
        SectionLayout.setShown(chosen, !scene.cameras().isEmpty());
        String kept = CameraEdits.keptName(scene);
        if (kept.isEmpty()) {
            list.showNothing();
        } else {
            list.show(kept);
        }
    }
}
