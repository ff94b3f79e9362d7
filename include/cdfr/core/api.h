/// Symbol visibility: everything is hidden but what carries CDFR_API.
#pragma once

#define CDFR_API __attribute__((visibility("default")))
