package lightning.editor.window.timeline;

import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.layout.HBox;
import lightning.base.text.Messages;

/** Row of the timeline: a name and its keyframes. */
final class TrackCell extends ListCell<TimelineRow> {
    /** Width of the names, pixels. */
    static final double NAME_WIDTH = 150;
    static final double HEIGHT = 20;

    private final TimelineModel timeline;
    private final Label name = new Label();
    private final KeyframeLane lane = new KeyframeLane();

    TrackCell(TimelineModel timeline) {
        this.timeline = timeline;
        name.setMinWidth(NAME_WIDTH);
        name.setMaxWidth(NAME_WIDTH);
        name.setPrefHeight(HEIGHT);
        name.getStyleClass().add("track-name");
        var row = new HBox(name, lane);
        row.setPrefHeight(HEIGHT);
        HBox.setHgrow(lane, javafx.scene.layout.Priority.ALWAYS);
        setGraphic(row);
        setPrefWidth(0);
        setPrefHeight(HEIGHT);
        timeline.scaleProperty().subscribe(_ -> draw());
        timeline.keyChoice().keysProperty().subscribe(_ -> draw());
    }

    @Override
    protected void updateItem(TimelineRow row, boolean empty) {
        super.updateItem(row, empty);
        getGraphic().setVisible(!empty);
        getStyleClass().removeAll("thing");
        if (!empty) {
            name.setText(switch (row) {
                case TimelineRow.ObjectRow t -> TrackNames.name(t.target());
                case TimelineRow.TrackRow t -> TrackNames.attribute(t.track());
            });
            name.setAccessibleText(Messages.tr("keyframes of {0}", name.getText()));
            if (row instanceof TimelineRow.ObjectRow) {
                getStyleClass().add("thing");
            }
            draw();
        }
    }

    private void draw() {
        if (!isEmpty() && getItem() != null) {
            lane.show(getItem(), timeline.scaleProperty().get(), timeline.keyChoice().keys(), HEIGHT);
        }
    }
}
