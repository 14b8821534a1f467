package lightning.editor.window.model;

import java.io.IOException;
import lightning.base.file.FileErrorMessage;
import lightning.base.text.Messages;
import lightning.base.text.UserFacingException;
import lightning.render.relight.PictureTooLargeException;

/** Converts an exception to a message for the user. */
public final class ErrorMessage {
    private ErrorMessage() {}

    public static String of(Throwable problem) {
        return switch (problem) {
            case UserFacingException e -> e.getMessage();
            case IOException e -> FileErrorMessage.of(e);
            case PictureTooLargeException e -> Messages.tr("Too large: {0}", e.getMessage());
            case OutOfMemoryError _ -> Messages.tr("Not enough memory for this resolution; choose a smaller one");
            default -> Messages.tr("Internal error: {0}; please report it with the scene", problem);
        };
    }
}
