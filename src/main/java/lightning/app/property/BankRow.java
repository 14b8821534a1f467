package lightning.app.property;

import java.util.Optional;
import java.util.function.UnaryOperator;
import javafx.collections.ObservableSet;
import javafx.css.PseudoClass;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.control.Tooltip;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import lightning.app.model.EditorModel;
import lightning.app.widget.Paints;
import lightning.edit.BankEdits;
import lightning.scene.Bank;
import lightning.scene.Limits;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignA;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;

/** A bank in the list of lights: whether its lights are listed, its gel, name and master, solo and on. A double click renames it. */
final class BankRow extends HBox {
    private static final PseudoClass REFUSED = PseudoClass.getPseudoClass("refused");

    private final EditorModel model;
    private final ObservableSet<String> folded;
    private final Runnable renamed;
    private final Button fold = new Button();
    private final FontIcon arrow = new FontIcon();
    private final Region gel = new Region();
    private final Label name = new Label();
    private final TextField field = new TextField();
    private final Label master = new Label();
    private final ToggleButton solo = LightCell.toggle("solo");
    private final ToggleButton on = LightCell.toggle("on");
    private final FontIcon bulb = new FontIcon();
    private Bank shown;

    /**
     * @param folded  the names of the banks whose lights are not listed
     * @param renamed called when a name was taken: keys go on to the list
     */
    BankRow(EditorModel model, ObservableSet<String> folded, Runnable renamed) {
        this.model = model;
        this.folded = folded;
        this.renamed = renamed;
        getStyleClass().addAll("light-row", "bank-row");
        fold.setGraphic(arrow);
        fold.getStyleClass().addAll("flat", "fold");
        fold.setFocusTraversable(false);
        fold.setOnAction(_ -> fold());
        gel.getStyleClass().add("light-chip");
        name.setMaxWidth(Double.MAX_VALUE);
        setHgrow(name, Priority.ALWAYS);
        setHgrow(field, Priority.ALWAYS);
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
        field.setAccessibleText("new name");
        field.setOnAction(_ -> rename());
        field.addEventFilter(KeyEvent.KEY_PRESSED, event -> {
            if (event.getCode() == KeyCode.ESCAPE) {
                endRename();
                event.consume();
            }
        });
        field.focusedProperty().addListener((_, was, _) -> {
            if (was) {
                endRename();
            }
        });
        getChildren().addAll(fold, gel, name, master, solo, on);
    }

    void show(Bank bank) {
        shown = bank;
        boolean closed = folded.contains(bank.name());
        arrow.setIconCode(closed ? MaterialDesignC.CHEVRON_RIGHT : MaterialDesignC.CHEVRON_DOWN);
        fold.setAccessibleText((closed ? "list the lights of " : "fold ") + bank.name());
        gel.setStyle("-fx-background-color: " + Paints.css(bank.color()) + ";");
        name.setText(bank.name());
        master.setText(bank.intensity() == 1 ? "" : "× " + Limits.text(Math.rint(bank.intensity() * 100) / 100));
        LightCell.describe(solo, bank.name() + " solo", "Show only the lights of banks and lights that are solo");
        bulb.setIconCode(LightTypes.bulb(bank.on()));
        LightCell.describe(on, bank.name() + " on", bank.on() ? "Switch all of its lights off" : "Let its lights shine");
        solo.setSelected(bank.solo());
        on.setSelected(bank.on());
    }

    /** For screen readers. */
    String text() {
        return shown.name() + ", bank of lights" + (shown.on() ? "" : ", off") + (shown.solo() ? ", solo" : "");
    }

    private void fold() {
        if (!folded.remove(shown.name())) {
            folded.add(shown.name());
        }
    }

    private void edit(UnaryOperator<Bank> edit) {
        String bank = shown.name();
        model.edit(scene -> BankEdits.with(scene, bank, edit)).ifPresent(model::say);
    }

    void startRename() {
        field.setText(shown.name());
        mark(Optional.empty());
        getChildren().set(getChildren().indexOf(name), field);
        field.requestFocus();
        field.selectAll();
    }

    private void rename() {
        String old = shown.name();
        String typed = field.getText().strip();
        Optional<String> refusal = model.edit(scene -> BankEdits.rename(scene, old, typed));
        mark(refusal);
        refusal.ifPresentOrElse(model::say, () -> {
            endRename();
            renamed.run();
        });
    }

    private void mark(Optional<String> refusal) {
        field.pseudoClassStateChanged(REFUSED, refusal.isPresent());
        field.setTooltip(refusal.map(Tooltip::new).orElse(null));
        field.setAccessibleHelp(refusal.orElse(""));
    }

    private void endRename() {
        int place = getChildren().indexOf(field);
        if (place >= 0) {
            getChildren().set(place, name);
        }
    }
}
