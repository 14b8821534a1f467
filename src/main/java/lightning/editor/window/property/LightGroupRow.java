package lightning.editor.window.property;

import java.util.function.UnaryOperator;
import javafx.collections.ObservableSet;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import lightning.base.text.Messages;
import lightning.editor.document.LightGroupEdits;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.DisplayColors;
import lightning.editor.window.widget.LightTypes;
import lightning.scene.LightGroup;
import lightning.scene.SceneLimits;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;

/** A bank in the list of lights: whether its lights are listed, its gel, name and master, solo and on. A double click renames it. */
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
    private LightGroup group;

    /**
     * @param collapsedGroups  the names of the banks whose lights are not listed
     * @param onRenamed called when a name was taken: keys go on to the list
     */
    LightGroupRow(SceneEditor editor, ObservableSet<String> collapsedGroups, Runnable onRenamed) {
        this.editor = editor;
        this.collapsedGroups = collapsedGroups;
        getStyleClass().addAll("light-row", "bank-row");
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
        master.getStyleClass().add("bank-master");
        master.setMinWidth(USE_PREF_SIZE);
        solo.setGraphic(new FontIcon(MaterialDesignA.ALPHA_S_CIRCLE));
        solo.setOnAction(_ -> edit(b -> b.withSolo(solo.isSelected())));
        onToggle.setGraphic(bulb);
        onToggle.setOnAction(_ -> edit(b -> b.withOn(onToggle.isSelected())));
        getChildren().addAll(foldButton, gel, name, master, solo, onToggle);
    }

    void show(LightGroup bank) {
        group = bank;
        boolean isCollapsed = collapsedGroups.contains(bank.name());
        arrow.setIconCode(isCollapsed ? MaterialDesignC.CHEVRON_RIGHT : MaterialDesignC.CHEVRON_DOWN);
        foldButton.setAccessibleText((isCollapsed ? Messages.tr("expand ") : Messages.tr("collapse ")) + bank.name());
        gel.setStyle("-fx-background-color: " + DisplayColors.css(bank.color()) + ";");
        name.setText(bank.name());
        master.setText(bank.intensity() == 1 ? "" : "× " + SceneLimits.format(Math.rint(bank.intensity() * 100) / 100));
        LightCell.describe(solo, Messages.tr("{0} solo", bank.name()),
                Messages.tr("Mute all lights and light groups that are not solo"));
        bulb.setIconCode(LightTypes.onIcon(bank.on()));
        LightCell.describe(onToggle, Messages.tr("{0} on", bank.name()),
                bank.on() ? Messages.tr("Switch off the group") : Messages.tr("Switch on the group"));
        solo.setSelected(bank.solo());
        onToggle.setSelected(bank.on());
    }

    /** For screen readers. */
    String text() {
        return Messages.tr("{0}, light group", group.name()) + (group.on() ? "" : Messages.tr(", off"))
                + (group.solo() ? Messages.tr(", solo") : "");
    }

    private void toggleExpanded() {
        if (!collapsedGroups.remove(group.name())) {
            collapsedGroups.add(group.name());
        }
    }

    private void edit(UnaryOperator<LightGroup> edit) {
        String bank = group.name();
        editor.editOrReport(scene -> LightGroupEdits.edit(scene, bank, edit));
    }

    void startRename() {
        field.open(group.name());
    }

    private void endRename() {
        field.close();
    }
}
