package lightning.editor.window.property;

import static java.util.Objects.requireNonNull;

import java.util.function.UnaryOperator;
import javafx.collections.ObservableSet;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import lightning.base.text.Messages;
import lightning.document.LightGroupEdits;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisplayColors;
import lightning.editor.window.widget.LightTypes;
import lightning.scene.light.LightGroup;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;

/** Row of a light group in the light list: expander, gel, name, master, solo and on switches. A double click renames the group. */
final class LightGroupRow extends HBox {
    private final SceneEditor editor;
    private final ObservableSet<String> collapsedGroups;
    private final Button foldButton = new Button();
    private final FontIcon arrow = new FontIcon();
    private final Region gel = new Region();
    private final Label name = new Label();
    private final NameField field;
    private final Label master = new Label();
    private final ToggleButton solo = LightCell.toggle("solo");
    private final ToggleButton onToggle = LightCell.toggle("on");
    private final FontIcon bulb = new FontIcon();
    private @Nullable LightGroup group;

    /**
     * @param collapsedGroups  names of the collapsed light groups
     * @param onRenamed  runs after renaming, to return the focus to the list
     */
    LightGroupRow(SceneEditor editor, ObservableSet<String> collapsedGroups, Runnable onRenamed) {
        this.editor = editor;
        this.collapsedGroups = collapsedGroups;
        getStyleClass().addAll("light-row", "group-row");
        foldButton.setGraphic(arrow);
        foldButton.getStyleClass().addAll("flat", "fold");
        foldButton.setFocusTraversable(false);
        foldButton.setOnAction(_ -> toggleExpanded());
        gel.getStyleClass().add("light-chip");
        field = new NameField(name, (old, typed) -> editor.editOrReport(scene -> LightGroupEdits.rename(scene, old, typed)), () -> {
            endRename();
            onRenamed.run();
        }, this::endRename);
        name.setOnMouseClicked(event -> {
            if (event.getClickCount() == 2) {
                startRename();
            }
        });
        master.getStyleClass().add("group-master");
        master.setMinWidth(USE_PREF_SIZE);
        solo.setGraphic(new FontIcon(MaterialDesignA.ALPHA_S_CIRCLE));
        solo.setOnAction(_ -> edit(b -> b.withSolo(solo.isSelected())));
        onToggle.setGraphic(bulb);
        onToggle.setOnAction(_ -> edit(b -> b.withOn(onToggle.isSelected())));
        getChildren().addAll(foldButton, gel, name, master, solo, onToggle);
    }

    void show(LightGroup newGroup) {
        group = newGroup;
        boolean isCollapsed = collapsedGroups.contains(newGroup.name());
        arrow.setIconCode(isCollapsed ? MaterialDesignC.CHEVRON_RIGHT : MaterialDesignC.CHEVRON_DOWN);
        foldButton.setAccessibleText((isCollapsed ? Messages.tr("expand ") : Messages.tr("collapse ")) + newGroup.name());
        gel.setStyle("-fx-background-color: " + DisplayColors.css(newGroup.color()) + ";");
        name.setText(newGroup.name());
        master.setText(newGroup.intensity() == 1 ? "" : "× " + SceneLimits.format(Math.rint(newGroup.intensity() * 100) / 100));
        LightCell.describe(solo, Messages.tr("{0} solo", newGroup.name()),
                Messages.tr("Mute all lights and light groups that are not solo"));
        bulb.setIconCode(LightTypes.onIcon(newGroup.on()));
        LightCell.describe(onToggle, Messages.tr("{0} on", newGroup.name()),
                newGroup.on() ? Messages.tr("Switch off the group") : Messages.tr("Switch on the group"));
        solo.setSelected(newGroup.solo());
        onToggle.setSelected(newGroup.on());
    }

    /** Returns the text for screen readers. */
    String text() {
        return Messages.tr("{0}, light group", shownGroup().name()) + (shownGroup().on() ? "" : Messages.tr(", off"))
                + (shownGroup().solo() ? Messages.tr(", solo") : "");
    }

    private void toggleExpanded() {
        if (!collapsedGroups.remove(shownGroup().name())) {
            collapsedGroups.add(shownGroup().name());
        }
    }

    private void edit(UnaryOperator<LightGroup> edit) {
        String groupName = shownGroup().name();
        editor.editOrReport(scene -> LightGroupEdits.edit(scene, groupName, edit));
    }

    void startRename() {
        field.open(shownGroup().name());
    }

    private void endRename() {
        field.close();
    }

    /** Returns the group of the row, which shows one before its controls are used. */
    private LightGroup shownGroup() {
        return requireNonNull(group);
    }
}
