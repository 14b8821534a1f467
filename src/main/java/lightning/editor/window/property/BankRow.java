package lightning.editor.window.property;

import java.util.function.UnaryOperator;
import javafx.collections.ObservableSet;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import lightning.base.text.Texts;
import lightning.editor.document.BankEdits;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.LightTypes;
import lightning.editor.window.widget.Paints;
import lightning.scene.Bank;
import lightning.scene.Limits;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;

/** A bank in the list of lights: whether its lights are listed, its gel, name and master, solo and on. A double click renames it. */
final class BankRow extends HBox {
    private final SceneEditor editor;
    private final ObservableSet<String> folded;
    private final Button fold = new Button();
    private final FontIcon arrow = new FontIcon();
    private final Region gel = new Region();
    private final Label name = new Label();
    private final NameField field;
    private final Label master = new Label();
    private final ToggleButton solo = LightCell.toggle("solo");
    private final ToggleButton on = LightCell.toggle("on");
    private final FontIcon bulb = new FontIcon();
    private Bank shown;

    /**
     * @param folded  the names of the banks whose lights are not listed
     * @param renamed called when a name was taken: keys go on to the list
     */
    BankRow(SceneEditor editor, ObservableSet<String> folded, Runnable renamed) {
        this.editor = editor;
        this.folded = folded;
        getStyleClass().addAll("light-row", "bank-row");
        fold.setGraphic(arrow);
        fold.getStyleClass().addAll("flat", "fold");
        fold.setFocusTraversable(false);
        fold.setOnAction(_ -> fold());
        gel.getStyleClass().add("light-chip");
        field = new NameField(name, (old, typed) -> editor.editOrReport(scene -> BankEdits.rename(scene, old, typed)), () -> {
            endRename();
            renamed.run();
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
        on.setGraphic(bulb);
        on.setOnAction(_ -> edit(b -> b.withOn(on.isSelected())));
        getChildren().addAll(fold, gel, name, master, solo, on);
    }

    void show(Bank bank) {
        shown = bank;
        boolean closed = folded.contains(bank.name());
        arrow.setIconCode(closed ? MaterialDesignC.CHEVRON_RIGHT : MaterialDesignC.CHEVRON_DOWN);
        fold.setAccessibleText((closed ? Texts.of("list the lights of ") : Texts.of("fold ")) + bank.name());
        gel.setStyle("-fx-background-color: " + Paints.css(bank.color()) + ";");
        name.setText(bank.name());
        master.setText(bank.intensity() == 1 ? "" : "× " + Limits.text(Math.rint(bank.intensity() * 100) / 100));
        LightCell.describe(solo, Texts.of("{0} solo", bank.name()), Texts.of("Show only the lights of banks and lights that are solo"));
        bulb.setIconCode(LightTypes.bulb(bank.on()));
        LightCell.describe(on, Texts.of("{0} on", bank.name()),
                bank.on() ? Texts.of("Switch all of its lights off") : Texts.of("Let its lights shine"));
        solo.setSelected(bank.solo());
        on.setSelected(bank.on());
    }

    /** For screen readers. */
    String text() {
        return Texts.of("{0}, bank of lights", shown.name()) + (shown.on() ? "" : Texts.of(", off"))
                + (shown.solo() ? Texts.of(", solo") : "");
    }

    private void fold() {
        if (!folded.remove(shown.name())) {
            folded.add(shown.name());
        }
    }

    private void edit(UnaryOperator<Bank> edit) {
        String bank = shown.name();
        editor.editOrReport(scene -> BankEdits.with(scene, bank, edit));
    }

    void startRename() {
        field.open(shown.name());
    }

    private void endRename() {
        field.close();
    }
}
