package lightning.editor.window.widget;

import java.util.List;
import java.util.stream.Collectors;
import javafx.beans.Observable;
import javafx.beans.binding.Bindings;
import javafx.scene.control.Label;

/** The reason why a typed number was refused, below its field; takes no room while there is none. */
final class RefusalLabel extends Label {
    RefusalLabel(List<NumberField> fields) {
        getStyleClass().add("refusal");
        setWrapText(true);
        textProperty().bind(Bindings.createStringBinding(
                () -> fields.stream().map(f -> f.refusalProperty().get()).filter(s -> !s.isEmpty())
                        .collect(Collectors.joining("; ")),
                fields.stream().map(NumberField::refusalProperty).toArray(Observable[]::new)));
        visibleProperty().bind(textProperty().isNotEmpty());
        managedProperty().bind(visibleProperty());
    }
}
