package lightning.editor.window.property;

import static java.util.Objects.requireNonNull;

import java.util.Optional;
import java.util.function.BiFunction;
import javafx.collections.ObservableSet;
import javafx.css.PseudoClass;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.document.LightEdits;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisplayColors;
import lightning.editor.window.widget.LightTypes;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;

/**
 * Cell of the light list: type, color, name, solo and on switches of a light, or a light group. A double click renames the light; dragging
 * moves it between light groups.
 */
final class LightCell extends NamedCell<LightListRow> {
    private static final PseudoClass DARK = PseudoClass.getPseudoClass("dark");
    private static final PseudoClass MEMBER = PseudoClass.getPseudoClass("member");

    private final FontIcon type = new FontIcon();
    private final Region chip = new Region();
    private final ToggleButton solo = toggle("solo");
    private final ToggleButton onToggle = toggle("on");
    private final FontIcon bulb = new FontIcon();
    private final SceneEditor editor;
    private final HBox row;
    private final LightGroupRow groupRow;
    private @Nullable Light shownLight;

    /** @param collapsedGroups  names of the collapsed light groups */
    LightCell(SceneEditor editor, CommandRegistry commands, ObservableSet<String> collapsedGroups) {
        super(commands, Command.RENAME_LIGHT, (old, typed) -> editor.editOrReport(scene -> LightEdits.rename(scene, old, typed)));
        this.editor = editor;
        groupRow = new LightGroupRow(editor, collapsedGroups, () -> getListView().requestFocus());
        LightGroupDrop.install(this, editor);
        LinkDrop.acceptShapes(this, editor);
        type.getStyleClass().add("light-type");
        chip.getStyleClass().add("light-chip");
        solo.setGraphic(new FontIcon(MaterialDesignA.ALPHA_S_CIRCLE));
        solo.setOnAction(_ -> edit((scene, light) -> LightEdits.setSolo(scene, light, solo.isSelected())));
        onToggle.setGraphic(bulb);
        onToggle.setOnAction(_ -> edit((scene, light) -> LightEdits.setOn(scene, light, onToggle.isSelected())));
        row = new HBox(type, chip, name, solo, onToggle);
        row.getStyleClass().add("light-row");
        editor.sceneProperty().subscribe(_ -> show());
        setOnMouseClicked(event -> {
            if (event.getClickCount() == 2 && getItem() instanceof LightListRow.LightRow) {
                commands.run(Command.RENAME_LIGHT);
            }
        });
    }

    static ToggleButton toggle(String styleClass) {
        ToggleButton button = new ToggleButton();
        button.getStyleClass().add(styleClass);
        button.setFocusTraversable(false);
        button.setTooltip(new Tooltip());
        return button;
    }

    private void edit(BiFunction<Scene, String, EditOutcome> edit) {
        String light = requireNonNull(shownLight).name();
        editor.editOrReport(scene -> edit.apply(scene, light));
    }

    /** Returns the cell's light. */
    @Nullable
    Light light() {
        return getItem() instanceof LightListRow.LightRow(int place) && place < editor.scene().lights().size()
                ? editor.scene().lights().get(place) : null;
    }

    /** Returns the light group of the cell or of its light; empty for none. */
    String groupName() {
        return getItem() instanceof LightListRow.GroupRow(int place) && place < editor.scene().rig().lightGroups().size()
                ? editor.scene().rig().lightGroups().get(place).name() : light() == null ? "" : light().lightGroup();
    }

    /** Starts renaming the cell's light group. */
    void renameGroup() {
        groupRow.startRename();
    }

    @Override
    protected void updateItem(@Nullable LightListRow item, boolean empty) {
        super.updateItem(item, empty);
        setGraphic(empty || item == null ? null : switch (item) {
            case LightListRow.LightRow _ -> row;
            case LightListRow.GroupRow _ -> groupRow;
        });
        if (empty || item == null) {
            setAccessibleText(null);
        }
        show();
    }

    private void show() {
        show(light());
        if (getItem() instanceof LightListRow.GroupRow(int place) && place < editor.scene().rig().lightGroups().size()) {
            groupRow.show(editor.scene().rig().lightGroups().get(place));
            setAccessibleText(groupRow.text());
        }
    }

    private void show(@Nullable Light light) {
        if (light != null && light != shownLight) {
            row.pseudoClassStateChanged(MEMBER, !light.lightGroup().isEmpty());
            type.setIconCode(LightTypes.icon(light.type()));
            chip.setStyle("-fx-background-color: " + DisplayColors.css(light.emission().tinted(light.color())) + ";");
            name.setText(light.name());
            describe(solo, Messages.tr("{0} solo", light.name()), Messages.tr("Mute all lights that are not solo"));
            bulb.setIconCode(LightTypes.onIcon(light.on()));
            describe(onToggle, Messages.tr("{0} on", light.name()), Messages.tr("Switch the light on or off"));
            setAccessibleText(light.name() + ", " + LightTypes.phrase(light.type())
                    + (light.on() ? "" : Messages.tr(", off")) + (light.solo() ? Messages.tr(", solo") : ""));
        }
        shownLight = light;
        if (light != null) {
            // The click has toggled the buttons, regardless of the edit's result.
            solo.setSelected(light.solo());
            onToggle.setSelected(light.on());
            // A soloed light mutes this one.
            row.pseudoClassStateChanged(DARK, !editor.scene().isActive(light));
        }
    }

    static void describe(ToggleButton button, String name, String hint) {
        button.setAccessibleText(name);
        button.getTooltip().setText(hint);
    }

    @Override
    Optional<String> renameTarget() {
        return light() == null ? Optional.empty() : Optional.of(requireNonNull(shownLight).name());
    }
}
