package lightning.editor.window.property;

import java.util.Optional;
import java.util.function.BiFunction;
import javafx.collections.ObservableSet;
import javafx.css.PseudoClass;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.document.LightEdits;
import lightning.editor.window.model.Commands;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.LightTypes;
import lightning.editor.window.widget.Paints;
import lightning.scene.Light;
import lightning.scene.Scene;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;

/**
 * A line of the list: a light's type, colour, name, solo and on, which a double click renames in place; or a bank. A light is dragged into a
 * bank, or out of one.
 */
final class LightCell extends NamedCell<RigRow> {
    private static final PseudoClass DARK = PseudoClass.getPseudoClass("dark");
    private static final PseudoClass MEMBER = PseudoClass.getPseudoClass("member");

    private final FontIcon type = new FontIcon();
    private final Region chip = new Region();
    private final ToggleButton solo = toggle("solo");
    private final ToggleButton on = toggle("on");
    private final FontIcon bulb = new FontIcon();
    private final SceneEditor editor;
    private final HBox row;
    private final BankRow bank;
    private Light shown;

    /** @param folded the names of the banks whose lights are not listed */
    LightCell(SceneEditor editor, Commands commands, ObservableSet<String> folded) {
        super(commands, Command.RENAME_LIGHT, (old, typed) -> editor.editOrReport(scene -> LightEdits.rename(scene, old, typed)));
        this.editor = editor;
        bank = new BankRow(editor, folded, () -> getListView().requestFocus());
        BankDrop.between(this, editor);
        LinkDrop.ontoLight(this, editor);
        type.getStyleClass().add("light-type");
        chip.getStyleClass().add("light-chip");
        solo.setGraphic(new FontIcon(MaterialDesignA.ALPHA_S_CIRCLE));
        solo.setOnAction(_ -> edit((scene, light) -> LightEdits.solo(scene, light, solo.isSelected())));
        on.setGraphic(bulb);
        on.setOnAction(_ -> edit((scene, light) -> LightEdits.on(scene, light, on.isSelected())));
        row = new HBox(type, chip, name, solo, on);
        row.getStyleClass().add("light-row");
        editor.sceneProperty().subscribe(_ -> show());
        setOnMouseClicked(event -> {
            if (event.getClickCount() == 2 && getItem() instanceof RigRow.OfLight) {
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

    private void edit(BiFunction<Scene, String, Change> edit) {
        String light = shown.name();
        editor.editOrReport(scene -> edit.apply(scene, light));
    }

    /** The light at the cell's place; null where there is none. */
    Light light() {
        return getItem() instanceof RigRow.OfLight(int place) && place < editor.scene().lights().size()
                ? editor.scene().lights().get(place) : null;
    }

    /** The bank whose line it is, or in which its light is; empty for none. */
    String bank() {
        return getItem() instanceof RigRow.OfBank(int place) && place < editor.scene().rig().banks().size()
                ? editor.scene().rig().banks().get(place).name() : light() == null ? "" : light().bank();
    }

    /** Renames the bank whose line it is. */
    void renameBank() {
        bank.startRename();
    }

    @Override
    protected void updateItem(RigRow item, boolean empty) {
        super.updateItem(item, empty);
        setGraphic(empty || item == null ? null : switch (item) {
            case RigRow.OfLight _ -> row;
            case RigRow.OfBank _ -> bank;
        });
        if (empty || item == null) {
            setAccessibleText(null);
        }
        show();
    }

    private void show() {
        show(light());
        if (getItem() instanceof RigRow.OfBank(int place) && place < editor.scene().rig().banks().size()) {
            bank.show(editor.scene().rig().banks().get(place));
            setAccessibleText(bank.text());
        }
    }

    private void show(Light light) {
        if (light != null && light != shown) {
            row.pseudoClassStateChanged(MEMBER, !light.bank().isEmpty());
            type.setIconCode(LightTypes.icon(light.type()));
            chip.setStyle("-fx-background-color: " + Paints.css(light.color()) + ";");
            name.setText(light.name());
            describe(solo, Texts.of("{0} solo", light.name()), Texts.of("Show only the lights that are solo"));
            bulb.setIconCode(LightTypes.bulb(light.on()));
            describe(on, Texts.of("{0} on", light.name()), light.on() ? Texts.of("Switch off") : Texts.of("Switch on"));
            setAccessibleText(light.name() + ", " + LightTypes.light(light.type())
                    + (light.on() ? "" : Texts.of(", off")) + (light.solo() ? Texts.of(", solo") : ""));
        }
        shown = light;
        if (light != null) {
            // A click has switched them already, whatever came of it.
            solo.setSelected(light.solo());
            on.setSelected(light.on());
            // Another light that is solo darkens this one.
            row.pseudoClassStateChanged(DARK, !editor.scene().shines(light));
        }
    }

    static void describe(ToggleButton button, String name, String hint) {
        button.setAccessibleText(name);
        button.getTooltip().setText(hint);
    }

    @Override
    Optional<String> renamed() {
        return light() == null ? Optional.empty() : Optional.of(shown.name());
    }
}
