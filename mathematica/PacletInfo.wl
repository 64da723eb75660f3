PacletObject[<|
  "Name" -> "OccupancyGrid",
  "Version" -> "1.0.0",
  "WolframVersion" -> "13.0+",
  "Description" -> "Occupancy grid mapping, the same bits in every language",
  "Extensions" -> {
    {"Kernel", "Root" -> ".", "Context" -> "OccupancyGrid`"}}|>]
