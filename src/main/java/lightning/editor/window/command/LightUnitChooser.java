package lightning.editor.window.command;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;
import javafx.scene.text.TextAlignment;
import lightning.base.text.Messages;
import lightning.editor.window.widget.PixelImage;
import lightning.format.exchange.LightUnits;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;

/** Buttons for the possible units of a file's light intensities, each with a preview. */
final class LightUnitChooser extends VBox {
    private static final double GAP = 12;

    private Optional<LightUnits> chosen = Optional.empty();

    /**
     * @param maxWidth  maximum width in logical pixels; the previews shrink to fit
     * @param onChosen  runs after a choice
     */
    LightUnitChooser(Map<LightUnits, Film> pictures, double maxWidth, Runnable onChosen) {
        super(GAP);
        var explanation =
                new Label(
                        Messages.tr("The file does not state the unit of its light intensities. These previews leave out textures."));
        explanation.setWrapText(true);
        var cards = new HBox(GAP);
        pictures.forEach((units, film) -> {
            var picture = new ImageView(image(film));
            picture.setPreserveRatio(true);
            // Leaves more than half a gap between a card's edge and its picture.
            picture.setFitWidth(Math.min(film.width(), (maxWidth - GAP) / pictures.size() - 3 * GAP));
            var card = new Button(title(units), picture);
            card.setPrefWidth(picture.getFitWidth() + 2 * GAP);
            card.setWrapText(true);
            card.setTextAlignment(TextAlignment.CENTER);
            card.setId("units-" + units.name().toLowerCase(Locale.ROOT));
            card.setContentDisplay(ContentDisplay.TOP);
            card.setAccessibleText(Messages.tr("Read intensities as {0}", units.description()));
            card.setOnAction(_ -> {
                chosen = Optional.of(units);
                onChosen.run();
            });
            cards.getChildren().add(card);
        });
        // The text wraps at the width of the cards.
        explanation.prefWidthProperty().bind(cards.widthProperty());
        explanation.setMaxWidth(USE_PREF_SIZE);
        getChildren().setAll(explanation, cards);
    }

    /** Returns the chosen unit, or empty. */
    Optional<LightUnits> chosen() {
        return chosen;
    }

    private static String title(LightUnits units) {
        return switch (units) {
            case CANDELA -> Messages.tr("Candela and lux (per the format)");
            case UNITLESS -> Messages.tr("Watts per steradian (unitless)");
            case WATTS -> Messages.tr("Watts");
        };
    }

    private static Image image(Film film) {
        return PixelImage.of(film.width(), film.height(), ViewTransform.DEFAULT.toPixels(film));
    }
}
