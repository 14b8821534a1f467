package lightning.serve;

import java.util.Locale;

/** Kind of an error, for programs. */
enum ErrorCode {
    /** The line is not one JSON object, or has no valid id. */
    BAD_MESSAGE,
    /** A method or field is missing, unknown or has a wrong value. */
    BAD_REQUEST,
    /** No open scene has that number. */
    UNKNOWN_SCENE,
    /** The scene file or text has problems. */
    BAD_SCENE,
    /** An edit names something that does not exist, or its value is invalid. */
    BAD_EDIT,
    /** A file cannot be read or written. */
    FILE,
    /** The picture does not fit into memory. */
    MEMORY,
    /** Too many scenes are open. */
    LIMIT,
    /** A client canceled the request. */
    CANCELED,
    /** A defect of the server. */
    INTERNAL;

    /** Returns the name in answers, such as {@code bad_edit}. */
    String text() {
        return name().toLowerCase(Locale.ROOT);
    }
}
