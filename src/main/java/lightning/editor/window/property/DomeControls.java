package lightning.editor.window.property;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ComboBox;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.base.text.NumberUnit;
import lightning.editor.document.Command;
import lightning.editor.document.DomeEdits;
import lightning.editor.document.EditorState;
import lightning.editor.document.StepRange;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.ArrowWidget;
import lightning.editor.window.widget.NumberSetting;
import lightning.format.jen.asset.FileKind;
import lightning.scene.Dome;
import lightning.scene.asset.Environment;
import lightning.scene.attribute.NumericKind;
import lightning.scene.attribute.SceneAttribute;
import org.jspecify.annotations.Nullable;

/** Further environments of the scene: a list, a menu that adds one, and the settings of the selected one. */
final class DomeControls extends VBox {
    private final SceneEditor editor;
    private final ComboBox<String> list = new ComboBox<>();
    private final Button delete = new Button(Messages.tr("Delete Dome"));
    private final CheckBox on = new CheckBox(Messages.tr("On"));
    private final CheckBox solo = new CheckBox(Messages.tr("Solo"));
    private final Map<SceneAttribute<Dome, ?>, ArrowWidget> numbers = new LinkedHashMap<>();
    private final FileField<Environment> image;
    private final VBox rows = new VBox();
    private boolean isUpdating;
    /** Names of the domes that are listed. */
    private List<String> shown = List.of();

    /** @param visibleState state as in {@link PropertyPane} */
    DomeControls(EditorModel model, ObservableValue<EditorState> visibleState) {
        editor = model.editor();
        list.setId("domes");
        list.setAccessibleText(Messages.tr("Domes"));
        list.setMaxWidth(Double.MAX_VALUE);
        list.valueProperty().addListener((_, _, _) -> {
            if (!isUpdating) {
                show(editor.editorStateProperty().getValue());
            }
        });
        delete.setId("delete-dome");
        delete.setOnAction(_ -> editor.editOrReport(scene -> DomeEdits.delete(scene, selected())));
        on.setId("dome-on");
        on.setTooltip(new Tooltip(Messages.tr("A dome that is off is neither seen nor lights anything")));
        on.setOnAction(_ -> edit(Dome.ON, on.isSelected()));
        solo.setId("dome-solo");
        solo.setTooltip(new Tooltip(Messages.tr("Mute all lights that are not solo")));
        solo.setOnAction(_ -> edit(Dome.SOLO, solo.isSelected()));
        var switches = new HBox(on, solo, delete);
        switches.getStyleClass().add("switches");
        image = FileField.forDome(editor, model.commands(), model.fileImporter(), this::selected, visibleState);
        List<ArrowWidget> widgets = new ArrayList<>();
        Dome.ATTRIBUTES.forEach(attribute -> number(attribute).ifPresent(widgets::add));
        rows.getChildren().addAll(image, switches);
        rows.getChildren().addAll(widgets);
        var add = new FileMenu(model.commands(), model.fileImporter(), Messages.tr("Add Dome"), Command.CHOOSE_ENVIRONMENT,
                FileKind.ENVIRONMENT, file -> add(model, file), () -> model.fileImporter().promptAndImport(
                        Command.CHOOSE_ENVIRONMENT.plainTitle(), FileKind.ENVIRONMENT, file -> add(model, file), editor.message()::show));
        add.setId("add-dome");
        add.setMaxWidth(Double.MAX_VALUE);
        add.setTooltip(new Tooltip(Messages.tr("Add an environment image whose light and picture are added to the others")));
        List.of(this, rows).forEach(part -> part.getStyleClass().add("section-rows"));
        HBox.setHgrow(list, Priority.ALWAYS);
        getChildren().addAll(list, rows, add);
        visibleState.subscribe(this::show);
    }

    /** Reads an image in the background and adds it as a dome, which it selects. */
    private void add(EditorModel model, String file) {
        if (!file.isEmpty()) {
            DomeFiles.add(model, file, DomeEdits::add);
        }
    }

    private String selected() {
        return list.getValue() == null ? "" : list.getValue();
    }

    private <V> void edit(SceneAttribute<Dome, V> attribute, V value) {
        String name = selected();
        editor.editOrReport(scene -> DomeEdits.edit(scene, name, dome -> attribute.with(dome, value)));
    }

    private <V> Optional<ArrowWidget> number(SceneAttribute<Dome, V> attribute) {
        if (!(attribute.kind() instanceof NumericKind<V> quantity)) {
            return Optional.empty();
        }
        NumberUnit unit = attribute.unit().startsWith("degrees") ? NumberUnit.DEGREES : NumberUnit.FACTOR;
        var setting = NumberSetting.of(attribute.title(), new StepRange(quantity.step(), quantity.min(), quantity.max()), unit,
                (value, gesture) -> {
                    String name = selected();
                    return editor.edit(scene -> DomeEdits.edit(scene, name,
                            dome -> attribute.with(dome, quantity.with(attribute.get(dome), 0, value))), gesture);
                });
        var widget = new ArrowWidget(SectionLayout.title(attribute.title()), attribute.title(), setting);
        widget.setId("dome-" + attribute.name());
        numbers.put(attribute, widget);
        return Optional.of(widget);
    }

    /** Discards uncommitted input. */
    void revert() {
        numbers.values().forEach(ArrowWidget::revert);
    }

    private void show(@Nullable EditorState state) {
        if (state == null) {
            return;
        }
        List<Dome> domes = state.scene().world().named();
        List<String> names = domes.stream().map(Dome::name).toList();
        if (!names.equals(shown)) {
            showNames(names);
        }
        Optional<Dome> dome = state.scene().world().dome(selected());
        WorldPane.setShown(list, !domes.isEmpty());
        WorldPane.setShown(rows, dome.isPresent());
        dome.ifPresent(this::show);
        // Another dome may be selected without a change of the scene.
        image.show(state);
    }

    /** Lists other names; selects a new one, or the one at the place of one that is gone. */
    private void showNames(List<String> names) {
        String added = names.stream().filter(name -> !shown.contains(name)).reduce((_, last) -> last).orElse("");
        boolean isFirst = shown.isEmpty();
        int index = Math.min(Math.max(0, shown.indexOf(selected())), names.size() - 1);
        String next = isFirst && !names.isEmpty() ? names.getFirst()
                : !added.isEmpty() ? added : names.contains(selected()) || index < 0 ? selected() : names.get(index);
        shown = names;
        isUpdating = true;
        list.getItems().setAll(names);
        list.setValue(names.isEmpty() ? null : next);
        isUpdating = false;
    }

    private void show(Dome dome) {
        on.setSelected(dome.on());
        solo.setSelected(dome.solo());
        numbers.forEach((attribute, widget) -> show(attribute, widget, dome));
    }

    private static <V> void show(SceneAttribute<Dome, V> attribute, ArrowWidget widget, Dome dome) {
        widget.setDisabledReason(dome.inactiveReason(attribute));
        widget.show(((NumericKind<V>) attribute.kind()).number(attribute.get(dome), 0));
    }
}
